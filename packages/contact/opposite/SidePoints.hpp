#pragma once

#include "bem/quadrature/Gauss.hpp"
#include "contact/opposite/Opposite.hpp"

namespace epafi::contact {

/// A quadrature point of a contact side and its opposite point.
struct SidePoint {
  const MultiplierSpace::ContactElement& contact;
  double t;
  double weight;  ///< quadrature weight, by arc length
  bem::Vec2 normal;
  bem::Vec2 tangent;
  Opposite::Point opposite;

  /// Calls visit(number, χ_i(t), d) for the coefficients of the element, without those at
  /// clamped ends.  d: normal or tangent; chi: values χ_i(t).
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

/// Calls visit(point) for the quadrature points of the contact sides of a body, in order: on each
/// stretch those of *ruleOf(contact element, opposite point of its midpoint); stretches with a
/// null rule are skipped.
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
