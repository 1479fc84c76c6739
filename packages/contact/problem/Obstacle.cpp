#include "contact/problem/Obstacle.hpp"

#include "bem/base/Error.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "contact/multiplier/BoundCoefficients.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

namespace {

using bem::Vec2;
using ContactElement = MultiplierSpace::ContactElement;

bool isClamped(const ContactElement& contact, int i) {
  return (i == 0 && contact.normalCompletions[0].clamped) ||
         (i == contact.degree && contact.normalCompletions[1].clamped);
}

void addGap(const bem::Mesh& mesh, const MultiplierSpace& multiplier,
            const ContactElement& contact, bem::Units units, Obstacle& obstacle) {
  const bem::Element& element = mesh[contact.element];
  const bem::Rule& rule = bem::gaussLegendre(contact.degree + 12);
  for (int q = 0; q < rule.size(); ++q) {
    const Vec2 x = mesh.physicalPoint(contact.element, rule.points[q]);
    const double gap =
        contact.condition->gap ? contact.condition->gap(x) / units.length : 0.0;
    obstacle.largestPenetration = std::max(obstacle.largestPenetration, -gap);
    const Vector chi = multiplier.basis().values(contact.degree, rule.points[q]);
    for (int i = 0; i <= contact.degree; ++i)
      if (!isClamped(contact, i))
        obstacle.gap[static_cast<std::size_t>(contact.normalOf(i))] +=
            rule.weights[q] * element.half * gap * chi[static_cast<std::size_t>(i)];
  }
}

double strengthAt(const ContactElement& contact, Vec2 x) {
  const double strength =
      contact.condition->strength ? contact.condition->strength(x) : 0.0;
  if (!(strength >= 0 && std::isfinite(strength)))
    throw bem::InputError(bem::message(
        "boundary '", *contact.boundary, "': ", contact.condition->law->parameter, " = ",
        strength, " at (", x.x, ", ", x.y, "); it must be finite and not negative"));
  return strength;
}

Tangential tangentialOf(const PressureBound& bound, const ContactElement& contact,
                        int i) {
  Tangential result{contact.normalOf(i), contact.condition->law, bound.strengths(i, i)};
  for (int j = 0; j <= contact.degree; ++j)
    if (j != i && bound.strengths(i, j) != 0)
      result.others.push_back({contact.normalOf(j), bound.strengths(i, j)});
  result.least = bound.least;
  result.most = bound.most;
  return result;
}

void setStrengths(const bem::Mesh& mesh, const MultiplierSpace& multiplier,
                  const ContactElement& contact, bem::Units units, Obstacle& obstacle) {
  const FrictionLaw& law = *contact.condition->law;
  const auto strength = [&](double t) {
    return strengthAt(contact, mesh.physicalPoint(contact.element, t));
  };
  const auto set = [&](int i, const Tangential& tangential) {
    const Index k = contact.tangentialOf(i) - multiplier.normals();
    if (ContactElement::isOwn(contact.tangentialEnds, contact.degree, i))
      obstacle.tangentials[static_cast<std::size_t>(k)] = tangential;
  };
  if (law.dependsOnPressure) {
    const PressureBound bound =
        pressureBound(multiplier.basis(), contact.degree, strength);
    for (int i = 0; i <= contact.degree; ++i)
      set(i, tangentialOf(bound, contact, i));
    return;
  }
  const Vector strengths =
      boundCoefficients(multiplier.basis(), contact.degree, strength);
  for (int i = 0; i <= contact.degree; ++i) {
    const double own = strengths[static_cast<std::size_t>(i)];
    set(i, {contact.normalOf(i), &law, law.strengthIsStress ? own / units.stress : own});
  }
}

}  // namespace

Obstacle makeObstacle(const bem::Mesh& mesh, const MultiplierSpace& multiplier,
                      bem::Units units) {
  Obstacle obstacle;
  obstacle.gap.assign(static_cast<std::size_t>(multiplier.normals()), 0.0);
  obstacle.tangentials.resize(
      static_cast<std::size_t>(multiplier.size() - multiplier.normals()));
  for (const ContactElement& contact : multiplier.elements()) {
    addGap(mesh, multiplier, contact, units, obstacle);
    if (contact.tangential >= 0)
      setStrengths(mesh, multiplier, contact, units, obstacle);
  }
  return obstacle;
}

}  // namespace epafi::contact
