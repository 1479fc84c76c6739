#pragma once

#include "bem/quadrature/Gauss.hpp"
#include "contact/opposite/Opposite.hpp"

namespace epafi::contact {

/// A point of a contact side's quadrature, and what it meets.
struct SidePoint {
  const MultiplierSpace::ContactElement& contact;
  double t;
  double weight;  ///< sums over points of this and a function are its integrals ds
  bem::Vec2 normal;
  bem::Vec2 tangent;
  Opposite::Point met;

  /// visit(number, χ_i(t), d) of the element's coefficients that the displacement can be held
  /// to, d: the direction in which one acts; χ: the values of its basis functions at t.
  template <class Visit>
  void forEachCoefficient(const Vector& chi, const Visit& visit) const {
    for (int i = 0; i <= contact.degree; ++i) {
      if (!contact.holdsNothing(contact.normalCompletions, i))
        visit(contact.normalOf(i), chi[at(i)], normal);
      if (contact.tangential >= 0 &&
          !contact.holdsNothing(contact.tangentialCompletions, i))
        visit(contact.tangentialOf(i), chi[at(i)], tangent);
    }
  }
};

/// visit(point) of the points by which integrals over a body's contact sides are taken, in order:
/// on each stretch those of *ruleOf(contact element, what the stretch's middle meets); null:
/// the stretch is left out.
template <class RuleOf, class Visit>
void forEachSidePoint(const bem::Mesh& side,
                      const std::vector<MultiplierSpace::ContactElement>& elements,
                      const Opposite& opposite, const RuleOf& ruleOf,
                      const Visit& visit) {
  for (const auto& contact : elements) {
    const bem::Element& element = side[contact.element];
    for (const auto& [middle, half] : stretches(opposite, contact)) {
      const bem::Rule* rule = ruleOf(contact, opposite.at(contact, middle));
      for (int q = 0; rule != nullptr && q < rule->size(); ++q) {
        const double t = middle + half * rule->points[at(q)];
        visit(SidePoint{contact, t, half * rule->weights[at(q)] * element.half,
                        element.curve.normal(t), element.curve.tangent(t),
                        opposite.at(contact, t)});
      }
    }
  }
}

}  // namespace epafi::contact
