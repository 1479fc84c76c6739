#pragma once

#include "bem/quadrature/Gauss.hpp"
#include "contact/opposite/Opposite.hpp"

namespace epafi::contact {

/// A quadrature point of a contact side.
struct SidePoint {
  const MultiplierSpace::ContactElement& contact;
  int number;                ///< of the point in its rule
  double t;                  ///< parameter on the element
  double weight;             ///< quadrature weight, by bem::Mesh::measure
  Vector chi;                ///< χ_i(t) of the element
  Opposite::Point opposite;  ///< of a loop that has been given what lies opposite
  Direction normal = opposite.direction;     ///< d of contact
  Direction tangent{turnLeft(normal.unit)};  ///< d turned left

  /// Number among the Gauss points of all elements, see forEachGaussPoint.
  std::size_t gaussPoint() const { return at(contact.point + number); }

  /// Weight of the stabilisation, with the radius in the middle of the element: its residual is
  /// zero where the solution is exact, and G stays diagonal.
  double stabilising() const {
    const bem::Mesh& mesh = *contact.mesh;
    return weight * (mesh.measure(contact.element, 0) / mesh.measure(contact.element, t));
  }
  /// Likewise of the element that it sees, by the measure of the side.
  double stabilisingOpposite(const bem::Mesh& seen) const {
    return weight * (seen.measure(opposite.element, 0) /
                     seen.measure(opposite.element, opposite.t));
  }

  /// χ_i(t) and d of its coefficient i in a row.
  double chiOf(int i) const { return chi[at(contact.functionOf(i))]; }
  const Direction& directionOf(int i) const {
    return contact.isTangential(i) ? tangent : normal;
  }

  /// Calls visit(number, χ_i(t), d) for the coefficients of the element, without those at
  /// clamped ends.
  template <class Visit>
  void forEachCoefficient(const Visit& visit) const {
    for (int i = 0; i < contact.coefficients(); ++i)
      if (!contact.of(i).holdsNothing(contact.functionOf(i)))
        visit(contact.numberOf(i), chiOf(i), directionOf(i));
  }
};

/// The contact quadrature: calls visit(point) for the points of a rule on a stretch of a contact
/// element, in order.
/// \param stretch one of stretches(), or all of the element without what lies opposite
template <class Visit>
void forEachPointOf(const MultiplierSpace::ContactElement& contact,
                    const MultiplierBasis& basis, const bem::Rule& rule,
                    const Visit& visit, const Stretch& stretch = {}) {
  const bem::Element& element = contact.geometry();
  for (int q = 0; q < rule.size(); ++q) {
    const double t = stretch.middle + stretch.half * rule.points[at(q)];
    Opposite::Point opposite;
    if (stretch.opposite != nullptr)
      opposite = stretch.opposite->at(contact, t);
    else
      opposite.direction.unit = element.curve.normal(t);
    const double weight =
        stretch.half * rule.weights[at(q)] * contact.mesh->measure(contact.element, t);
    visit(SidePoint{contact, q, t, weight, basis.values(contact.degree, t), opposite});
  }
}

/// The same on a part that sees an element of a deformable body, where something presses on it.
template <class Visit>
void forEachPointOf(const Opposite::Seen& seen, const MultiplierBasis& basis,
                    const bem::Rule& rule, const Visit& visit) {
  forEachPointOf(
      *seen.by, basis, rule,
      [&](const SidePoint& point) {
        // a grazing normal may miss it
        if (point.opposite.element == seen.element && point.opposite.stretching > 0)
          visit(point);
      },
      seen.stretch);
}

/// The same on all contact elements, by the p + 1 Gauss points of each, which integrate χ_i χ_j
/// exactly.
template <class Visit>
void forEachGaussPoint(const MultiplierSpace& multiplier, const Visit& visit) {
  multiplier.forEachElement([&](const auto& contact) {
    forEachPointOf(contact, multiplier.basis(), bem::gaussLegendre(contact.degree + 1),
                   visit);
  });
}

/// The same with what lies opposite: on each stretch on which that is smooth by *ruleOf(contact
/// element, opposite point of its midpoint); stretches with a null rule are skipped.
template <class RuleOf, class Visit>
void forEachSidePoint(const MultiplierSpace& multiplier, const Opposite& opposite,
                      const RuleOf& ruleOf, const Visit& visit) {
  multiplier.forEachElement([&](const auto& contact) {
    for (const Stretch& stretch : stretches(opposite, contact))
      if (const bem::Rule* rule = ruleOf(contact, opposite.at(contact, stretch.middle)))
        forEachPointOf(contact, multiplier.basis(), *rule, visit, stretch);
  });
}

}  // namespace epafi::contact
