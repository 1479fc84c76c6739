// G and M of a body, and what a traction in λ's place does.
#include "bem/algebra/Products.hpp"
#include "bem/base/Error.hpp"
#include "bem/basis/Legendre.hpp"
#include "contact/body/Coupling.hpp"
#include "contact/opposite/SidePoints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace epafi::contact {

using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;

namespace {

/// values of functions times a force, by components: two rows a function.
void addForce(Vec2 force, const double* values, double* rows, Index size) {
  for (Index k = 0; k < size; k += 2) {
    rows[k] += force.x * values[k / 2];
    rows[k + 1] += force.y * values[k / 2];
  }
}

/// What one element of the stabilisation has of G and M: a contact element by its own coefficients; with
/// Form Density one that sides of other bodies see by theirs, -λ∘P⁻¹ ds_A/ds_f in λ's place.  G's rows: with
/// Form Density Legendre polynomials, the densities', where S u is evaluated orthonormal ones, else none.
class StabilisedElement {
 public:
  /// \param own  the contact element; null: others see it
  StabilisedElement(const MultiplierSpace& multiplier, std::size_t body,
                    const Coupling& coupling, int number, const ContactElement* own)
      : basis_(multiplier.basis()),
        mesh_(multiplier.mesh(body)),
        number_(number),
        element_(mesh_[number]),
        isOwn_(own != nullptr),
        byDensity_(coupling.stabilization.byDensity()),
        byTractions_(coupling.stabilization.tractions().has_value()) {
    if (!isOwn_)
      sides_ = coupling.opposite->seen(static_cast<int>(body), number);
    else
      for (const Stretch& stretch : stretches(*coupling.opposite, *own))
        sides_.push_back({own, stretch, -1});
  }

  void addTo(double gamma, Index firstRow, Coupling& coupling) const {
    for (auto first = sides_.begin(); first != sides_.end();) {
      const ContactElement& side = *first->by;
      const auto last = std::find_if(
          first, sides_.end(), [&](const auto& other) { return other.by != &side; });
      const auto [parts, mass] = integrals({first, last});
      for (int i = 0; i < side.coefficients(); ++i) {
        if (isLeftOut(side, i))
          continue;
        const Index number = side.numberOf(i);
        for (int k = 0; k < side.coefficients(); ++k)
          if (mass(i, k) != 0 && !isLeftOut(side, k))
            coupling.mass.push_back({number, side.numberOf(k), gamma * mass(i, k)});
        for (Index row = 0; row < rows(); ++row)
          coupling.weights.push_back(
              {firstRow + row, number, gamma * normOf(row) * parts(row, i)});
      }
      first = last;
    }
  }

  /// A traction in λ's place.
  void addMoments(double gamma, Index firstRow, const BoundaryTraction& traction,
                  const std::vector<BoundaryTraction>& tested,
                  Loads::InResidual& moments) const {
    Vector parts(at(rows()));
    Matrix testedParts(rows(), static_cast<Index>(tested.size()));
    const auto addOn = [&](double t, double weight, Vec2 force) {
      const auto functions = functionsAt(t);
      addForce(force, functions.data(), parts.data(), rows());
      for (std::size_t k = 0; k < tested.size(); ++k)
        if (const Vec2 r = tested[k](number_, t); isWhole())
          moments.means[k] += dot(force, r);
        else
          addForce(weight * r, functions.data(),
                   testedParts.column(static_cast<Index>(k)), rows());
    };
    for (const Opposite::Seen& seen : sides_)
      forEachPoint(seen, bem::gaussForGiven(seen.by->degree),
                   [&](const SidePoint& point, double t, double weight) {
                     const Vec2 force = gamma * weight * traction(number_, t);
                     if (isOwn_)
                       addOn(t, weight, force);
                     for (int i = 0; isWhole() && i < seen.by->coefficients(); ++i)
                       if (!isLeftOut(*seen.by, i))
                         moments.terms[at(seen.by->numberOf(i))] -=
                             sign() * point.chiOf(i) *
                             dot(force, point.directionOf(i).unit);
                   });
    const bem::Rule& rule = bem::gaussForGiven(element_.degree);
    for (int q = 0; !isOwn_ && q < rule.size(); ++q) {
      const double weight = mesh_.measure(number_, 0) * rule.weights[at(q)];
      const double t = rule.points[at(q)];
      addOn(t, weight, gamma * weight * traction(number_, t));
    }
    for (Index row = 0; row < rows(); ++row)
      moments.weights[at(firstRow + row)] = normOf(row) * parts[at(row)];
    if (isWhole())
      return;
    const auto timesParts = [&](const double* column) {
      return std::inner_product(parts.begin(), parts.end(), column, 0.0);
    };
    const ContactElement& side = *sides_.front().by;
    const Matrix ofSide = integrals(sides_).first;
    for (int i = 0; i < side.coefficients(); ++i)
      moments.terms[at(side.numberOf(i))] -= timesParts(ofSide.column(i));
    for (Index k = 0; k < testedParts.columns(); ++k)
      moments.means[at(k)] += timesParts(testedParts.column(k));
  }

 private:
  double sign() const { return isOwn_ ? 1 : -1; }
  Index rows() const {
    return 2 * (byDensity_ ? element_.densities : byTractions_ ? element_.degree + 1 : 0);
  }
  /// Ends that carry nothing are left out of what others see.
  bool isLeftOut(const ContactElement& side, int i) const {
    return !isOwn_ && side.of(i).holdsNothing(side.functionOf(i));
  }

  /// At a point of the element Legendre polynomials, orthonormal on contact elements, and what one of them is
  /// multiplied by to be that of G's row.
  std::array<double, bem::largestDegree + 2> functionsAt(double t) const {
    std::array<double, bem::largestDegree + 2> legendre{};
    const auto count = static_cast<int>(rows() / 2);
    bem::legendreValues(count - 1, t, legendre.data());
    for (int l = 0; isOwn_ && l < count; ++l)
      legendre[l] *= std::sqrt((2 * static_cast<double>(l) + 1) / (2 * element_.half));
    return legendre;
  }

  double normOf(Index row) const {
    const Index degree = row / 2;
    const auto l = static_cast<double>(degree);
    return isOwn_ && byDensity_ ? std::sqrt(2 * element_.half / (2 * l + 1)) : 1;
  }

  /// Where S u is projected on polynomials, so is λ: on arcs they leave something of it, and M is
  /// the product of what they take.
  bool isWhole() const { return !byTractions_ || element_.curve.pointsOfTurning() == 0; }

  /// visit(point, parameter on the element, weight)
  template <class Visit>
  void forEachPoint(const Opposite::Seen& seen, const bem::Rule& rule,
                    const Visit& visit) const {
    if (isOwn_)
      forEachPointOf(
          *seen.by, basis_, rule,
          [&](const SidePoint& point) { visit(point, point.t, point.stabilising()); },
          seen.stretch);
    else
      forEachPointOf(seen, basis_, rule, [&](const SidePoint& point) {
        visit(point, point.opposite.t, point.stabilisingOpposite(mesh_));
      });
  }

  /// ∫ χ_i d·P_l, components x coefficients, and ∫ χ_i χ_k of one direction, or of the former, on
  /// parts of one side.
  std::pair<Matrix, Matrix> integrals(const std::vector<Opposite::Seen>& side) const {
    const ContactElement& by = *side.front().by;
    const int size = by.coefficients();
    Matrix parts(rows(), size);
    Matrix mass(size, size);
    for (const Opposite::Seen& seen : side) {
      const Opposite::Point middle = seen.stretch.opposite->at(by, seen.stretch.middle);
      forEachPoint(seen, ruleOfForces(by, middle),
                   [&](const SidePoint& point, double t, double weight) {
                     const auto functions = functionsAt(t);
                     const double lengthening = isOwn_ ? 1 : point.opposite.stretching;
                     for (int i = 0; i < size; ++i) {
                       const double value = weight * point.chiOf(i);
                       addForce(sign() * value * point.directionOf(i).unit,
                                functions.data(), parts.column(i), rows());
                       for (int k = 0; k < size; ++k)
                         if (by.isTangential(k) == by.isTangential(i))
                           mass(i, k) += value * lengthening * point.chiOf(k);
                     }
                   });
    }
    if (!isWhole())
      mass = bem::transposedProduct(parts, parts);
    return {std::move(parts), std::move(mass)};
  }

  const MultiplierBasis& basis_;
  const bem::Mesh& mesh_;
  int number_;
  const bem::Element& element_;
  bool isOwn_;
  bool byDensity_;
  bool byTractions_;
  std::vector<Opposite::Seen> sides_;  ///< parts of one side after the other
};

/// The space and the stiffness, made by Conditions::facing, precede what lies opposite.
void checkFacing(const bem::Mesh& mesh, std::size_t body, const Coupling& coupling) {
  std::set<int> edges;
  for (const int e : coupling.elements)
    edges.insert(mesh[e].piece.edge);
  const auto isSeen = [&](int e) {
    const auto sources = coupling.opposite->sources(static_cast<int>(body), e, 0);
    return std::any_of(sources.begin(), sources.end(), [&](const auto& source) {
      return source.element->body != static_cast<int>(body);
    });
  };
  for (int e = 0; e < mesh.size(); ++e)
    if (const int edge = mesh[e].piece.edge; edges.count(edge) == 0 && isSeen(e))
      throw bem::InputError("a side in contact sees edge ", edge, " ('", mesh.boundary(e),
                            "') of body ", body,
                            ", which Conditions::facing of that body lacks; the "
                            "stabilisation's form Density needs it");
}

}  // namespace

Coupling stabilised(Coupling plain, const bem::Space& space,
                    const MultiplierSpace& multiplier, std::size_t body,
                    const Stabilization& stabilization, const bem::Lame& lame,
                    bem::Units units, std::vector<Index> start) {
  Coupling coupling = std::move(plain);
  coupling.stabilization = stabilization;
  if (stabilization.isOn() && !multiplier.elements(body).empty())
    coupling.gamma0 = stabilization.firstGamma0();
  coupling.compliance =
      densityCompliance(space, multiplier.conditions(body), stabilization, lame, units);
  const bool ofDensities = start.empty();
  coupling.start = ofDensities ? std::vector<Index>{0} : std::move(start);
  const std::vector<ContactElement>& contacts = multiplier.elements(body);
  coupling.elements =
      stabilisedElements(space.mesh(), multiplier.conditions(body), stabilization);
  if (stabilization.byDensity())
    checkFacing(space.mesh(), body, coupling);
  for (std::size_t k = 0; k < coupling.elements.size(); ++k) {
    const int e = coupling.elements[k];
    const double gamma = gammaOn(space.mesh(), e, stabilization, lame, units);
    const Index first = coupling.start[k];
    if (ofDensities)
      coupling.start.push_back(first + 2 * Index{space.mesh()[e].densities});
    coupling.gamma.push_back(gamma);
    if (gamma == 0)
      continue;
    const ContactElement* own = k < contacts.size() ? &contacts[k] : nullptr;
    StabilisedElement(multiplier, body, coupling, e, own).addTo(gamma, first, coupling);
  }
  return coupling;
}

Loads::InResidual tractionMoments(const MultiplierSpace& multiplier, std::size_t body,
                                  const Coupling& coupling,
                                  const BoundaryTraction& traction,
                                  const std::vector<BoundaryTraction>& tested) {
  Loads::InResidual moments;
  moments.weights.assign(at(coupling.start.back()), 0.0);
  moments.terms.assign(at(multiplier.size()), 0.0);
  moments.means.assign(tested.size(), 0.0);
  const std::vector<ContactElement>& contacts = multiplier.elements(body);
  for (std::size_t k = 0; k < coupling.elements.size(); ++k) {
    const ContactElement* own = k < contacts.size() ? &contacts[k] : nullptr;
    if (const double gamma = coupling.gamma[k]; gamma != 0)
      StabilisedElement(multiplier, body, coupling, coupling.elements[k], own)
          .addMoments(gamma, coupling.start[k], traction, tested, moments);
  }
  return moments;
}

}  // namespace epafi::contact
