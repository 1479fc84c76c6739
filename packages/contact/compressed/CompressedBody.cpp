#include "contact/compressed/CompressedBody.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/compressed/Products.hpp"
#include "contact/opposite/MortarCoupling.hpp"
#include "contact/problem/Numbering.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::contact {

using bem::dot;

namespace {

/// What a multiplier does to the rotation of a body with arcs.
template <class Number>
void addRests(const std::shared_ptr<const bem::Rotation>& rotation, std::size_t body,
              Index first, const Vector& rests, const Number& numberOf,
              CompressedCoupling& to) {
  if (rotation == nullptr)
    return;
  Vector values(at(to.multipliers));
  for (std::size_t i = 0; i < rests.size(); ++i)
    values[at(numberOf(static_cast<Index>(i)))] = rests[i];
  to.rests.push_back({rotation, body, first, std::move(values)});
}

/// Ĉ and M of a body's own multiplier, numbered from `first` on and as `numberOf` says.
template <class Number>
void addOwn(const bem::Space& space, const Coupling& coupling, std::size_t body,
            Index first, const Number& numberOf, CompressedCoupling& to) {
  for (const Coupling::Entry& entry : coupling.trace)
    to.entries.push_back({first + entry.row, numberOf(entry.column), entry.value});
  for (const Coupling::Entry& entry : coupling.weights)
    to.entries.push_back(
        {first + space.displacements() + coupling.compliance.densities[at(entry.row)],
         numberOf(entry.column), -entry.value});
  for (const Coupling::Entry& entry : coupling.mass)
    to.mass.push_back({numberOf(entry.row), numberOf(entry.column), entry.value});
  addRests(coupling.rotation, body, first, coupling.traceOfRotation, numberOf, to);
}

/// Where each coefficient of the multiplier belongs, so that a leaf has as many as it has
/// displacements which they act on: to an element of its function where it does work on what
/// that one numbers, on most of it if there are two; else, as at the end of a contact, to the
/// one that numbers what it does most work on.  Tangential ones go to that of the pressure
/// which they may follow.  Control points, whose bounds follow all pressures of an element,
/// belong to it.
std::vector<int> elementsOf(const bem::Space& space, const MultiplierSpace& multiplier,
                            const Coupling& coupling) {
  std::vector<int> elements(at(coupling.multipliers), 0);
  if (multiplier.basis().controlPoints) {
    for (const MultiplierSpace::ContactElement& contact : multiplier.elements())
      for (int i = 0; i <= contact.degree; ++i) {
        elements[at(contact.normalOf(i))] = contact.element;
        if (contact.tangential >= 0)
          elements[at(contact.tangentialOf(i))] = contact.element;
      }
    return elements;
  }
  std::vector<int> elementOf(at(space.displacements()));
  for (int e = 0; e < space.mesh().size(); ++e)
    for (Index i = space.displacement(e, 0, 0);
         i < space.displacement(e, 0, 0) + 2 * space.mesh()[e].degree; ++i)
      elementOf[at(i)] = e;
  std::vector<std::vector<int>> homes(elements.size());
  for (const MultiplierSpace::ContactElement& contact : multiplier.elements())
    for (int i = 0; i <= contact.degree; ++i) {
      homes[at(contact.normalOf(i))].push_back(contact.element);
      if (contact.tangential >= 0)
        homes[at(contact.tangentialOf(i))].push_back(contact.element);
    }
  constexpr double rounding = 1e-6;
  Vector largest(at(coupling.multipliers), 0.0);
  for (const Coupling::Entry& entry : coupling.trace) {
    const int e = elementOf[at(entry.row)];
    const std::vector<int>& own = homes[at(entry.column)];
    const double work = std::abs(entry.value) *
                        (std::count(own.begin(), own.end(), e) > 0 ? 1 : rounding);
    if (work > largest[at(entry.column)]) {
      largest[at(entry.column)] = work;
      elements[at(entry.column)] = e;
    }
  }
  for (const MultiplierSpace::ContactElement& contact : multiplier.elements())
    for (int i = 0; i <= contact.degree && contact.tangential >= 0; ++i)
      elements[at(contact.tangentialOf(i))] = elements[at(contact.normalOf(i))];
  return elements;
}

class CompressedBody final : public StabilisedBody {
 public:
  CompressedBody(const bem::Space& space,
                 std::shared_ptr<const bem::CompressedOperators> operators,
                 std::size_t number, Coupling coupling)
      : operators_(std::move(operators)),
        number_(number),
        range_(operators_->range(number)),
        coupling_(std::move(coupling)) {
    compressed_.multipliers = coupling_.multipliers;
    addOwn(
        space, coupling_, number, range_.first, [](Index i) { return i; }, compressed_);
  }

  std::shared_ptr<const HeldStiffness> held(const Holding& holding) const override {
    return std::make_shared<const Held>(*this, holding);
  }

  // f - (W u + K' ψ), ψ that of u
  Vector residual(const Vector& force, const Vector& u) const override {
    Vector rest = force;
    const Matrix& images = fieldOf(u).images;
    for (std::size_t i = 0; i < rest.size(); ++i)
      rest[i] -= images(range_.first + static_cast<Index>(i), 0) +
                 images(range_.first + static_cast<Index>(i), 1);
    return rest;
  }

  Matrix coupling() const override { return {}; }

  Vector push(const Vector& multiplier) const override {
    Matrix x(operators_->size(), 1);
    compressed_.push(1, multiplier.data(), x.data());
    if (byDensity()) {
      // what (V + G)⁻¹ (-N λ) does through K'
      const Matrix image = operators_->times(placed({}, densityUnder(multiplier)));
      for (Index i = range_.first; i < range_.densities; ++i)
        x(i, 0) += image(i, 0);
    }
    for (const Coupling::Entry& entry : coupling_.completion)
      x(range_.first + entry.row, 0) += entry.value * multiplier[at(entry.column)];
    Vector force(x.data() + range_.first, x.data() + range_.densities);
    if (coupling_.rotation != nullptr)
      coupling_.rotation->complete(dot(coupling_.completionOfRotation, multiplier),
                                   force);
    return force;
  }

  Vector pull(const Vector& u) const override {
    const Matrix x = placed(u, byDensity() ? fieldOf(u).psi : Vector());
    return compressed_.pull(x.data());
  }

  Matrix multiplierMass() const override { return coupling_.multiplierMass(); }
  double multiplierWork(const Vector& multiplier) const override {
    const double work = coupling_.multiplierWork(multiplier);
    if (!byDensity())
      return work;
    // less (N λ)ᵀ (V + G)⁻¹ N λ
    Matrix pushed(operators_->size(), 1);
    compressed_.push(1, multiplier.data(), pushed.data());
    const Vector& psi = densityUnder(multiplier);
    return work - std::inner_product(psi.begin(), psi.end(),
                                     pushed.data() + range_.densities, 0.0);
  }

  // (V + G)⁻¹ (K u - N λ)
  Vector density(const Vector& u, const Vector& multiplier) const override {
    Vector psi = fieldOf(u).psi;
    if (byDensity() && !multiplier.empty())
      bem::axpy(1, densityUnder(multiplier), psi);
    return psi;
  }

  // 1/2 uᵀ W u + 1/2 ψᵀ V ψ from Z's products with u and ψ, -(V + G) there
  double strainEnergy(const Vector& u, const Vector& multiplier) const override {
    const Vector psi = density(u, multiplier);
    const Matrix own = byDensity() ? imagesOf(u, psi) : Matrix();
    const Matrix& images = byDensity() ? own : fieldOf(u).images;
    const double twice =
        std::inner_product(u.begin(), u.end(), images.column(0) + range_.first, 0.0) -
        std::inner_product(psi.begin(), psi.end(), images.column(1) + range_.densities,
                           0.0);
    return 0.5 * (twice - coupling_.complianceWork(psi));
  }

  bool byDensity() const override { return !coupling_.compliance.densities.empty(); }

  bem::Vec2 meanSlack(std::size_t contactElement, const Vector& multiplier,
                      const Vector& density) const override {
    return coupling_.meanSlack(contactElement, multiplier, density);
  }

  double gamma(std::size_t contactElement) const override {
    return coupling_.gamma[contactElement];
  }
  Matrix subtracted() const override { return {}; }
  std::unique_ptr<const StabilisedBody> weakened(double) const override {
    return nullptr;
  }

 private:
  class Held final : public HeldStiffness {
   public:
    Held(const CompressedBody& body, const Holding& holding)
        : body_(body),
          holding_(holding),
          held_(std::make_shared<const CompressedHolding>(*body.operators_, body.number_,
                                                          holding)),
          range_(body.range_) {}

    // A⁺ f + R Rᵀ f
    Vector solve(const Vector& force) const override {
      Matrix forces(held_->operators().size(), 1);
      std::copy(force.begin(), force.end(), forces.data() + range_.first);
      const Matrix x = held_->displaced(std::move(forces));
      body_.solved_.assign(x.data() + range_.densities, x.data() + range_.last);
      Vector u(x.data() + range_.first, x.data() + range_.densities);
      for (Index k = 0; k < holding_.rigid.allowed.columns(); ++k) {
        const Vector r = columnOf(holding_.rigid.allowed, k);
        bem::axpy(dot(r, force), r, u);
      }
      return u;
    }
    Matrix forward(Matrix) const override { return {}; }
    std::shared_ptr<const CompressedHolding> compressed() const override { return held_; }

   private:
    const CompressedBody& body_;
    const Holding& holding_;
    std::shared_ptr<const CompressedHolding> held_;
    const bem::CompressedOperators::Range& range_;
  };

  /// A displacement and a density among all unknowns; empty: zero.
  Matrix placed(const Vector& u, const Vector& psi) const {
    Matrix x(operators_->size(), 1);
    std::copy(u.begin(), u.end(), x.data() + range_.first);
    std::copy(psi.begin(), psi.end(), x.data() + range_.densities);
    return x;
  }
  /// Of V + G: all displacements and multipliers held.
  const bem::CompressedFactor& densityFactor() const {
    if (densityFactor_ == nullptr) {
      bem::Restriction restriction;
      restriction.held.assign(at(operators_->size()), 1);
      std::fill(restriction.held.begin() + range_.densities,
                restriction.held.begin() + range_.last, 0);
      densityFactor_ = std::make_unique<const bem::CompressedFactor>(
          *operators_, restriction, std::vector<int>{});
    }
    return *densityFactor_;
  }

  /// -(V + G)⁻¹ N λ; the last one is kept.
  const Vector& densityUnder(const Vector& multiplier) const {
    if (multiplier != pushed_) {
      Matrix right(operators_->size(), 1);
      compressed_.push(-1, multiplier.data(), right.data());
      densityUnder_ = densityFor(right);
      pushed_ = multiplier;
    }
    return densityUnder_;
  }

  /// The densities' rows solved, all else held: -(V + G)⁻¹ of them.
  Vector densityFor(const Matrix& right) const {
    const Matrix psi = densityFactor().solve(right);
    return {psi.data() + range_.densities, psi.data() + range_.last};
  }

  /// Z (u, 0) and Z (0, ψ)
  Matrix imagesOf(const Vector& u, const Vector& psi) const {
    Matrix x(operators_->size(), 2);
    std::copy(u.begin(), u.end(), x.column(0) + range_.first);
    std::copy(psi.begin(), psi.end(), x.column(1) + range_.densities);
    return operators_->times(x);
  }

  /// A displacement, its ψ without a multiplier, and imagesOf both.
  struct Field {
    Vector u;
    Vector psi;
    Matrix images;
  };

  /// That of u; the last one is kept, which several results ask for.  A solution has its ψ
  /// with it: the last one's is tried first, and taken where K u - (V + G) ψ vanishes.
  const Field& fieldOf(const Vector& u) const {
    if (u == field_.u)
      return field_;
    Vector psi = solved_;
    psi.resize(at(range_.last - range_.densities));
    Matrix images = imagesOf(u, psi);
    double left = 0;
    double size = 0;
    for (Index i = range_.densities; i < range_.last; ++i) {
      left = std::max(left, std::abs(images(i, 0) + images(i, 1)));
      size = std::max(size, std::abs(images(i, 0)));
    }
    if (left > 1e-12 * size) {
      for (Index i = 0; i < images.rows(); ++i)
        images(i, 0) = -images(i, 0);
      psi = densityFor(bem::columnsBetween(images, 0, 1));
      images = imagesOf(u, psi);
    }
    field_ = {u, std::move(psi), std::move(images)};
    return field_;
  }

  std::shared_ptr<const bem::CompressedOperators> operators_;
  std::size_t number_;
  const bem::CompressedOperators::Range& range_;
  Coupling coupling_;
  CompressedCoupling compressed_;  ///< the own multiplier's
  mutable std::unique_ptr<const bem::CompressedFactor> densityFactor_;
  mutable Vector solved_;  ///< ψ of the last solution
  mutable Field field_;
  mutable Vector pushed_;
  mutable Vector densityUnder_;
};

}  // namespace

std::string whyNotCompressed(const Stabilization& stabilization) {
  using Form = Stabilization::Form;
  if (stabilization.form != Form::None && stabilization.form != Form::Density)
    return "Discretization->Stabilization->Form must be Density, or None with the "
           "multiplier Biorthogonal";
  return "";
}

namespace {

Numbering numberingOf(const std::vector<CompressedInput>& bodies) {
  std::vector<Numbering::Count> counts;
  for (const CompressedInput& body : bodies)
    counts.push_back({body.multiplier.normals(), body.multiplier.size()});
  return Numbering(counts);
}

}  // namespace

CompressedCoupling makeCompressedCoupling(const std::vector<CompressedInput>& bodies,
                                          const Stabilization& stabilization,
                                          bem::Units units) {
  const Numbering numbering = numberingOf(bodies);
  CompressedCoupling result;
  result.multipliers = numbering.size();
  result.normals = numbering.normals();
  std::vector<Index> starts;
  for (const CompressedInput& body : bodies) {
    starts.push_back(result.first);
    result.first += body.space.displacements() + body.space.densities();
  }
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    const auto& [space, multiplier, lame, opposite] = bodies[a];
    const auto numberOf = [&](Index i) { return numbering(a, i); };
    addOwn(space, makeLocalCoupling(space, multiplier, stabilization, lame, units), a,
           starts[a], numberOf, result);
    if (opposite == nullptr)
      continue;
    for (const int b : opposite->bodies()) {
      const auto k = static_cast<std::size_t>(b);
      const MortarCoupling met =
          mortarCoupling(space.mesh(), multiplier, *opposite, bodies[k].space, b);
      for (const Coupling::Entry& entry : met.entries)
        result.entries.push_back(
            {starts[k] + entry.row, numberOf(entry.column), entry.value});
      addRests(met.rotation, k, starts[k], met.rests, numberOf, result);
    }
  }
  return result;
}

std::vector<bem::SteklovPoincare> makeCompressedStiffness(
    const std::vector<CompressedInput>& bodies, const Stabilization& stabilization,
    bem::Units units, const bem::DenseAlgebra& algebra, const bem::Compression& options) {
  const std::string reason = whyNotCompressed(stabilization);
  if (!reason.empty())
    throw bem::InputError("the operators cannot be compressed: " + reason);
  const CompressedCoupling coupling =
      makeCompressedCoupling(bodies, stabilization, units);
  bem::LocalCoupling local;
  for (const Coupling::Entry& entry : coupling.entries)
    local.entries.push_back({entry.row, coupling.first + entry.column, entry.value});
  for (const Coupling::Entry& entry : coupling.mass)
    if (entry.row >= entry.column)
      local.entries.push_back(
          {coupling.first + entry.row, coupling.first + entry.column, -entry.value});
  const Numbering numbering = numberingOf(bodies);
  local.rotations.assign(bodies.size(), Vector(at(coupling.multipliers)));
  for (const CompressedCoupling::Rest& rest : coupling.rests)
    bem::axpy(1, rest.values, local.rotations[rest.body]);
  local.elements.resize(at(coupling.multipliers));
  local.bodies.resize(at(coupling.multipliers));
  std::vector<bem::CompressedOperators::Body> operands;
  Index first = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto& [space, multiplier, lame, opposite] = bodies[b];
    operands.push_back({space, lame});
    const Coupling own = makeLocalCoupling(space, multiplier, stabilization, lame, units);
    const std::vector<int> elements = elementsOf(space, multiplier, own);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const Index k = numbering(b, static_cast<Index>(i));
      local.elements[at(k)] = elements[i];
      local.bodies[at(k)] = static_cast<int>(b);
    }
    const auto comply = [&](Index density, double value) {
      const Index i = first + space.displacements() + density;
      local.entries.push_back({i, i, -value});
    };
    for (std::size_t k = 0; k < own.compliance.densities.size(); ++k)
      comply(own.compliance.densities[k], own.compliance.diagonal[k]);
    for (const auto& [density, value] : own.compliance.pinned)
      comply(density, value);
    first += space.displacements() + space.densities();
  }
  const auto operators =
      std::make_shared<const bem::CompressedOperators>(operands, options, local);
  std::vector<bem::SteklovPoincare> result;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    result.emplace_back(operators, algebra, b);
  return result;
}

std::unique_ptr<const StabilisedBody> makeCompressedBody(
    const BodyInput& input, const MultiplierSpace& multiplier) {
  return std::make_unique<const CompressedBody>(
      input.space, input.stiffness.compressed(), input.stiffness.compressedBody(),
      makeLocalCoupling(input.space, multiplier, input.stabilization, input.lame,
                        input.units));
}

}  // namespace epafi::contact
