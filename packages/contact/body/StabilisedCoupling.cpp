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

/// What one contact element has of G and M, coefficients in a row.  G's rows: with Form Density
/// Legendre polynomials, the densities', where S u is evaluated orthonormal ones, else none.
class ElementCoupling {
 public:
  ElementCoupling(const MultiplierBasis& basis, const Opposite& opposite,
                  const Stabilization& stabilization, const ContactElement& contact)
      : basis_(basis),
        opposite_(opposite),
        byDensity_(stabilization.byDensity()),
        byTractions_(stabilization.tractions().has_value()),
        contact_(contact),
        element_(contact.geometry()),
        parts_(rows(), size()),
        mass_(size(), size()) {}

  void addTo(double gamma, Index firstRow, Coupling& coupling) {
    integrate();
    for (int i = 0; i < size(); ++i) {
      const Index number = contact_.numberOf(i);
      for (int k = 0; k < size(); ++k)
        if (mass_(i, k) != 0)
          coupling.mass.push_back({number, contact_.numberOf(k), gamma * mass_(i, k)});
      for (Index row = 0; row < rows(); ++row)
        coupling.weights.push_back(
            {firstRow + row, number, gamma * normOf(row) * parts_(row, i)});
    }
  }

  /// A traction in λ's place.
  void addMoments(double gamma, Index firstRow, const BoundaryTraction& traction,
                  const std::vector<BoundaryTraction>& tested,
                  Loads::InResidual& moments) {
    if (!isWhole())
      integrate();
    Vector parts(at(rows()));
    Matrix testedParts(rows(), static_cast<Index>(tested.size()));
    forEachPoint(
        [&](const Opposite::Point&) -> const auto& {
          return bem::gaussForGiven(element_.degree);
        },
        [&](const SidePoint& point) {
          const auto legendre = orthonormal(point.t);
          const double weight = point.stabilising();
          const Vec2 force = weight * traction(contact_.element, point.t);
          addForce(force, legendre.data(), parts.data(), rows());
          for (std::size_t k = 0; k < tested.size(); ++k) {
            const Vec2 r = tested[k](contact_.element, point.t);
            addForce(weight * r, legendre.data(),
                     testedParts.column(static_cast<Index>(k)), rows());
            if (isWhole())
              moments.means[k] += gamma * dot(force, r);
          }
          for (int i = 0; i < size() && isWhole(); ++i)
            moments.terms[at(contact_.numberOf(i))] -=
                gamma * point.chiOf(i) * dot(force, point.directionOf(i).unit);
        });
    const auto timesParts = [&](const double* column) {
      return gamma * std::inner_product(parts.begin(), parts.end(), column, 0.0);
    };
    for (int i = 0; i < size() && !isWhole(); ++i)
      moments.terms[at(contact_.numberOf(i))] -= timesParts(parts_.column(i));
    for (Index k = 0; k < testedParts.columns() && !isWhole(); ++k)
      moments.means[at(k)] += timesParts(testedParts.column(k));
    for (Index row = 0; row < rows(); ++row)
      moments.weights[at(firstRow + row)] = gamma * normOf(row) * parts[at(row)];
  }

 private:
  int size() const { return contact_.coefficients(); }
  /// The rows of the element's tractions, or its densities.
  Index rows() const {
    return 2 * (byDensity_ ? element_.densities : byTractions_ ? element_.degree + 1 : 0);
  }

  /// Legendre polynomials on the element, orthonormal, and what one of them is multiplied by to
  /// be that of G's row.
  std::array<double, bem::largestDegree + 2> orthonormal(double t) const {
    std::array<double, bem::largestDegree + 2> legendre{};
    const auto count = static_cast<int>(rows() / 2);
    bem::legendreValues(count - 1, t, legendre.data());
    for (int l = 0; l < count; ++l)
      legendre[l] *= std::sqrt((2 * static_cast<double>(l) + 1) / (2 * element_.half));
    return legendre;
  }
  double normOf(Index row) const {
    const Index degree = row / 2;
    const auto l = static_cast<double>(degree);
    return byDensity_ ? std::sqrt(2 * element_.half / (2 * l + 1)) : 1;
  }

  /// Where S u is projected on polynomials, so is λ: on arcs they leave something of it, and M is
  /// the product of what they take.
  bool isWhole() const { return !byTractions_ || element_.curve.pointsOfTurning() == 0; }

  template <class RuleOf, class Visit>
  void forEachPoint(const RuleOf& ruleOf, const Visit& visit) const {
    for (const Stretch& stretch : stretches(opposite_, contact_))
      forEachPointOf(contact_, basis_, ruleOf(opposite_.at(contact_, stretch.middle)),
                     visit, stretch);
  }

  void integrate() {
    forEachPoint(
        [&](const Opposite::Point& middle) -> const auto& {
          return ruleOfForces(contact_, middle);
        },
        [&](const SidePoint& point) { add(point); });
    if (!isWhole())
      mass_ = bem::transposedProduct(parts_, parts_);
  }

  void add(const SidePoint& point) {
    const auto legendre = orthonormal(point.t);
    const double weight = point.stabilising();
    for (int i = 0; i < size(); ++i) {
      const double value = weight * point.chiOf(i);
      addForce(value * point.directionOf(i).unit, legendre.data(), parts_.column(i),
               rows());
      for (int k = 0; k < size(); ++k)
        if (contact_.isTangential(k) == contact_.isTangential(i))
          mass_(i, k) += value * point.chiOf(k);
    }
  }

  const MultiplierBasis& basis_;
  const Opposite& opposite_;
  bool byDensity_;
  bool byTractions_;
  const ContactElement& contact_;
  const bem::Element& element_;
  Matrix parts_;  ///< ∫ χ_i d·P_l, P_l orthonormal: their components x coefficients
  Matrix mass_;   ///< ∫ χ_i χ_k of one direction, or of their parts
};

/// What sides of other bodies have of G and M on an element that they see, with Form Density.
class FacingCoupling {
 public:
  FacingCoupling(const MultiplierSpace& multiplier, const Opposite& opposite,
                 std::size_t body, int number)
      : basis_(multiplier.basis()),
        mesh_(multiplier.mesh(body)),
        number_(number),
        element_(mesh_[number]),
        seen_(opposite.seen(static_cast<int>(body), number)) {}

  void addTo(double gamma, Index firstRow, Coupling& coupling) const {
    for (const Opposite::Seen& seen : seen_) {
      const ContactElement& side = *seen.by;
      const int size = side.coefficients();
      Matrix parts(rows(), size);
      Matrix mass(size, size);
      const Opposite::Point middle = seen.stretch.opposite->at(side, seen.stretch.middle);
      forEachPointOf(
          seen, basis_, ruleOfForces(side, middle), [&](const SidePoint& point) {
            const auto legendre = legendreAt(point.opposite.t);
            const double weight = point.stabilisingOpposite(mesh_);
            for (int i = 0; i < size; ++i) {
              const double value = weight * point.chiOf(i);
              addForce(-value * point.directionOf(i).unit, legendre.data(),
                       parts.column(i), rows());
              for (int k = 0; k < size; ++k)
                if (side.isTangential(k) == side.isTangential(i))
                  mass(i, k) += value * point.opposite.stretching * point.chiOf(k);
            }
          });
      for (int i = 0; i < size; ++i) {
        if (holdsNothing(side, i))
          continue;
        for (Index row = 0; row < rows(); ++row)
          coupling.weights.push_back(
              {firstRow + row, side.numberOf(i), gamma * parts(row, i)});
        for (int k = 0; k < size; ++k)
          if (mass(i, k) != 0 && !holdsNothing(side, k))
            coupling.mass.push_back(
                {side.numberOf(i), side.numberOf(k), gamma * mass(i, k)});
      }
    }
  }

  /// A traction t in the residual t + ψ - λ∘P⁻¹ ds_A/ds_f.
  void addMoments(double gamma, Index firstRow, const BoundaryTraction& traction,
                  const std::vector<BoundaryTraction>& tested,
                  Loads::InResidual& moments) const {
    const bem::Rule& rule = bem::gaussForGiven(element_.degree);
    for (int q = 0; q < rule.size(); ++q) {
      const double t = rule.points[at(q)];
      const Vec2 force =
          gamma * mesh_.measure(number_, 0) * rule.weights[at(q)] * traction(number_, t);
      addForce(force, legendreAt(t).data(), moments.weights.data() + firstRow, rows());
      for (std::size_t k = 0; k < tested.size(); ++k)
        moments.means[k] += dot(force, tested[k](number_, t));
    }
    for (const Opposite::Seen& seen : seen_)
      forEachPointOf(seen, basis_, bem::gaussForGiven(seen.by->degree),
                     [&](const SidePoint& point) {
                       const Vec2 force = gamma * point.stabilisingOpposite(mesh_) *
                                          traction(number_, point.opposite.t);
                       point.forEachCoefficient(
                           [&](Index i, double chi, const Direction& direction) {
                             moments.terms[at(i)] += chi * dot(force, direction.unit);
                           });
                     });
  }

 private:
  Index rows() const { return 2 * static_cast<Index>(element_.densities); }
  std::array<double, bem::largestDegree + 2> legendreAt(double t) const {
    std::array<double, bem::largestDegree + 2> legendre{};
    bem::legendreValues(element_.densities - 1, t, legendre.data());
    return legendre;
  }
  static bool holdsNothing(const ContactElement& side, int i) {
    return side.of(i).holdsNothing(side.functionOf(i));
  }

  const MultiplierBasis& basis_;
  const bem::Mesh& mesh_;
  int number_;
  const bem::Element& element_;
  std::vector<Opposite::Seen> seen_;
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
    if (k < contacts.size())
      ElementCoupling(multiplier.basis(), *coupling.opposite, stabilization, contacts[k])
          .addTo(gamma, first, coupling);
    else
      FacingCoupling(multiplier, *coupling.opposite, body, e)
          .addTo(gamma, first, coupling);
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
    const double gamma = coupling.gamma[k];
    if (gamma == 0)
      continue;
    if (k < contacts.size())
      ElementCoupling(multiplier.basis(), *coupling.opposite, coupling.stabilization,
                      contacts[k])
          .addMoments(gamma, coupling.start[k], traction, tested, moments);
    else
      FacingCoupling(multiplier, *coupling.opposite, body, coupling.elements[k])
          .addMoments(gamma, coupling.start[k], traction, tested, moments);
  }
  return moments;
}

}  // namespace epafi::contact
