#include "contact/problem/CompressedBody.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/compressed/Products.hpp"
#include "contact/problem/CompressedFlexibility.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::contact {

using bem::dot;

namespace {

/// Ĉ and M with the numbers of unknowns.
CompressedCoupling compressedCoupling(const bem::Space& space,
                                      const MultiplierSpace& multiplier,
                                      const Coupling& coupling) {
  CompressedCoupling result;
  result.first = space.displacements() + space.densities();
  result.multipliers = coupling.multipliers;
  result.normals = multiplier.normals();
  result.entries = coupling.trace;
  result.mass = coupling.mass;
  for (const Coupling::Entry& entry : coupling.weights)
    result.entries.push_back(
        {space.displacements() + coupling.compliance.densities[at(entry.row)],
         entry.column, -entry.value});
  return result;
}

/// Where each coefficient of the multiplier belongs: to the element that numbers the
/// displacement which it does most work on, so that a leaf has both.
std::vector<int> elementsOf(const bem::Space& space, const Coupling& coupling) {
  std::vector<int> elementOf(at(space.displacements()));
  for (int e = 0; e < space.mesh().size(); ++e)
    for (Index i = space.displacement(e, 0, 0);
         i < space.displacement(e, 0, 0) + 2 * space.mesh()[e].degree; ++i)
      elementOf[at(i)] = e;
  std::vector<int> elements(at(coupling.multipliers), 0);
  Vector largest(at(coupling.multipliers), -1.0);
  for (const Coupling::Entry& entry : coupling.trace)
    if (std::abs(entry.value) > largest[at(entry.column)]) {
      largest[at(entry.column)] = std::abs(entry.value);
      elements[at(entry.column)] = elementOf[at(entry.row)];
    }
  return elements;
}

class CompressedBody final : public StabilisedBody {
 public:
  CompressedBody(const bem::Space& space, const MultiplierSpace& multiplier,
                 std::shared_ptr<const bem::CompressedOperators> operators,
                 Coupling coupling)
      : space_(space),
        operators_(std::move(operators)),
        coupling_(std::move(coupling)),
        compressed_(compressedCoupling(space, multiplier, coupling_)) {}

  std::shared_ptr<const HeldStiffness> held(const Holding& holding) const override {
    return std::make_shared<const Held>(*this, holding);
  }

  // f - (W u + K' ψ), ψ that of u
  Vector residual(const Vector& force, const Vector& u) const override {
    Vector rest = force;
    const Matrix& images = fieldOf(u).images;
    for (std::size_t i = 0; i < rest.size(); ++i)
      rest[i] -= images(static_cast<Index>(i), 0) + images(static_cast<Index>(i), 1);
    return rest;
  }

  Matrix coupling() const override { return {}; }

  Vector push(const Vector& multiplier) const override {
    Matrix x(operators_->size(), 1);
    compressed_.push(1, multiplier.data(), x.data());
    if (byDensity()) {
      // what (V + G)⁻¹ (-N λ) does through K'
      Matrix psi(operators_->size(), 1);
      const Vector& own = densityUnder(multiplier);
      std::copy(own.begin(), own.end(), psi.data() + displacements());
      const Matrix image = operators_->times(psi);
      for (Index i = 0; i < displacements(); ++i)
        x(i, 0) += image(i, 0);
    }
    for (const Coupling::Entry& entry : coupling_.completion)
      x(entry.row, 0) += entry.value * multiplier[at(entry.column)];
    return {x.data(), x.data() + displacements()};
  }

  Vector pull(const Vector& u) const override {
    Matrix x(operators_->size(), 1);
    std::copy(u.begin(), u.end(), x.data());
    if (byDensity()) {
      const Vector& psi = fieldOf(u).psi;
      std::copy(psi.begin(), psi.end(), x.data() + displacements());
    }
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
                                     pushed.data() + displacements(), 0.0);
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
    const double twice = std::inner_product(u.begin(), u.end(), images.column(0), 0.0) -
                         std::inner_product(psi.begin(), psi.end(),
                                            images.column(1) + displacements(), 0.0);
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
          held_(std::make_shared<const CompressedHolding>(*body.operators_,
                                                          body.compressed_, holding)),
          flexibility_(compressedFlexibility(held_)),
          size_(body.displacements()) {}

    // A⁺ f + R Rᵀ f
    Vector solve(const Vector& force) const override {
      Matrix forces(held_->operators().size(), 1);
      std::copy(force.begin(), force.end(), forces.data());
      const Matrix x = held_->displaced(std::move(forces));
      body_.solved_.assign(x.data() + size_, x.data() + body_.compressed_.first);
      Vector u(x.data(), x.data() + size_);
      for (Index k = 0; k < holding_.rigid.allowed.columns(); ++k) {
        const Vector r = columnOf(holding_.rigid.allowed, k);
        bem::axpy(dot(r, force), r, u);
      }
      return u;
    }
    Matrix forward(Matrix) const override { return {}; }
    std::shared_ptr<const Flexibility::Operator> flexibility() const override {
      return flexibility_;
    }

   private:
    const CompressedBody& body_;
    const Holding& holding_;
    std::shared_ptr<const CompressedHolding> held_;
    std::shared_ptr<const Flexibility::Operator> flexibility_;
    Index size_;
  };

  Index displacements() const { return space_.displacements(); }

  /// Of V + G: all displacements and multipliers held.
  const bem::CompressedFactor& densityFactor() const {
    if (densityFactor_ == nullptr) {
      bem::Restriction restriction;
      restriction.held.assign(at(operators_->size()), 1);
      std::fill(restriction.held.begin() + displacements(),
                restriction.held.begin() + compressed_.first, 0);
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
    return {psi.data() + displacements(), psi.data() + compressed_.first};
  }

  /// Z (u, 0) and Z (0, ψ)
  Matrix imagesOf(const Vector& u, const Vector& psi) const {
    Matrix x(operators_->size(), 2);
    std::copy(u.begin(), u.end(), x.column(0));
    std::copy(psi.begin(), psi.end(), x.column(1) + displacements());
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
    psi.resize(at(compressed_.first - displacements()));
    Matrix images = imagesOf(u, psi);
    double left = 0;
    double size = 0;
    for (Index i = displacements(); i < compressed_.first; ++i) {
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

  const bem::Space& space_;
  std::shared_ptr<const bem::CompressedOperators> operators_;
  Coupling coupling_;
  CompressedCoupling compressed_;
  mutable std::unique_ptr<const bem::CompressedFactor> densityFactor_;
  mutable Vector solved_;  ///< ψ of the last solution
  mutable Field field_;
  mutable Vector pushed_;
  mutable Vector densityUnder_;
};

}  // namespace

std::string whyNotCompressed(const bem::Outline& outline,
                             const Stabilization& stabilization) {
  using Form = Stabilization::Form;
  if (stabilization.form != Form::None && stabilization.form != Form::Density)
    return "Discretization->Stabilization->Form must be Density, or None with the "
           "multiplier Biorthogonal";
  for (const bem::Edge& edge : outline.edges())
    if (!edge.curve.isStraight())
      return "the outline has circular arcs, whose exact rotation no cluster holds";
  return "";
}

bem::SteklovPoincare makeCompressedStiffness(const bem::Space& space,
                                             const MultiplierSpace& multiplier,
                                             const Stabilization& stabilization,
                                             const bem::Lame& lame, bem::Units units,
                                             const bem::DenseAlgebra& algebra,
                                             const bem::Compression& options) {
  const std::string reason = whyNotCompressed(space.mesh().outline(), stabilization);
  if (!reason.empty())
    throw bem::InputError("the operators cannot be compressed: " + reason);
  const Coupling coupling =
      makeLocalCoupling(space, multiplier, stabilization, lame, units);
  const CompressedCoupling compressed = compressedCoupling(space, multiplier, coupling);
  bem::LocalCoupling local;
  local.elements = elementsOf(space, coupling);
  for (const Coupling::Entry& entry : compressed.entries)
    local.entries.push_back({entry.row, compressed.first + entry.column, entry.value});
  for (const Coupling::Entry& entry : compressed.mass)
    if (entry.row >= entry.column)
      local.entries.push_back(
          {compressed.first + entry.row, compressed.first + entry.column, -entry.value});
  const auto comply = [&](Index density, double value) {
    const Index i = space.displacements() + density;
    local.entries.push_back({i, i, -value});
  };
  for (std::size_t k = 0; k < coupling.compliance.densities.size(); ++k)
    comply(coupling.compliance.densities[k], coupling.compliance.diagonal[k]);
  for (const auto& [density, value] : coupling.compliance.pinned)
    comply(density, value);
  return bem::SteklovPoincare(
      std::make_shared<const bem::CompressedOperators>(space, lame, options, local),
      algebra);
}

std::unique_ptr<const StabilisedBody> makeCompressedBody(
    const ContactProblem::Input& input, const MultiplierSpace& multiplier) {
  return std::make_unique<const CompressedBody>(
      input.space, multiplier, input.stiffness.compressed(),
      makeLocalCoupling(input.space, multiplier, input.stabilization, input.lame,
                        input.units));
}

}  // namespace epafi::contact
