#include "contact/opposite/RigidBodies.hpp"

#include "bem/quadrature/Gauss.hpp"

#include <algorithm>

namespace epafi::contact {

namespace {

using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;

void addValue(const ContactElement& contact, const Vector& chi, Vec2 tangent, Vec2 motion,
              double* column) {
  for (int i = 0; i <= contact.degree; ++i) {
    const double value = chi[i];
    if (!contact.holdsNothing(contact.normalCompletions, i))
      column[contact.normalOf(i)] += value * dot(motion, turnRight(tangent));
    if (contact.tangential >= 0 &&
        !contact.holdsNothing(contact.tangentialCompletions, i))
      column[contact.tangentialOf(i)] += value * dot(motion, tangent);
  }
}

}  // namespace

RigidTraces rigidTraces(const bem::Mesh& side, const MultiplierSpace& multiplier,
                        const Opposite& opposite, int body) {
  RigidTraces result{Matrix(multiplier.size(), 3)};
  for (const ContactElement& contact : multiplier.elements()) {
    const bem::Element& element = side[contact.element];
    const bem::Rule& rule = bem::gaussForGiven(contact.degree);
    for (const auto& [middle, half] : stretches(opposite, contact)) {
      if (opposite.at(contact, middle).rigid != body)
        continue;
      result.length += 2 * half * element.half;
      for (int q = 0; q < rule.size(); ++q) {
        const double t = middle + half * rule.points[q];
        const Opposite::Point met = opposite.at(contact, t);
        const double weight = half * rule.weights[q] * element.half;
        const Vector chi = multiplier.basis().values(contact.degree, t);
        const Vec2 tangent = element.curve.tangent(t);
        result.lever = std::max(result.lever, norm(met.arm));
        const std::array<Vec2, 3> motions = {Vec2{1, 0}, Vec2{0, 1}, turnLeft(met.arm)};
        for (Index k = 0; k < 3; ++k)
          addValue(contact, chi, tangent, weight * motions[k], result.traces.column(k));
      }
    }
  }
  for (Index i = 0; i < multiplier.size() && result.lever > 0; ++i)
    result.traces(i, 2) /= result.lever;
  return result;
}

}  // namespace epafi::contact
