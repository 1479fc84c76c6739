#include "adaptivity/estimate/TurningArcs.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "contact/opposite/SidePoints.hpp"

#include <algorithm>

namespace epafi::adaptivity {

namespace {

/// <r_I, r>, by the rule of bem::Rotation.
double squareOf(const bem::Space& space) {
  const bem::Mesh& mesh = space.mesh();
  double square = 0;
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::Element& element = mesh[e];
    const bem::Rule& rule =
        bem::gaussLegendre(element.degree + std::max(1, element.curve.pointsOfTurning()));
    for (int q = 0; q < rule.size(); ++q) {
      const double t = rule.points[bem::at(q)];
      const bem::Vec2 r = space.rotation()->at(mesh.scaledPoint(e, t));
      square +=
          element.half * rule.weights[bem::at(q)] * dot(r - space.rotationRest(e, t), r);
    }
  }
  return square;
}

}  // namespace

double turningTraction(const contact::Solved& solved) {
  if (solved.space.rotation() == nullptr || solved.state.multiplier.empty())
    return 0;
  const auto number = static_cast<int>(solved.problem.number());
  const contact::MultiplierSpace& multiplier = solved.problem.multiplier();
  double moment = 0;
  forEachSidePoint(
      multiplier, solved.problem.opposite(),
      [&](const auto& contact, const contact::Opposite::Point& middle) {
        const bool acts =
            contact.body == number || (middle.element >= 0 && middle.body == number);
        return acts ? &ruleOfForces(contact, middle) : nullptr;
      },
      [&](const contact::SidePoint& point) {
        const contact::Direction& d = point.normal;
        double turn = point.contact.body == number ? d.ownTurn : 0;
        if (point.opposite.element >= 0 && point.opposite.body == number)
          turn -= d.oppositeTurn;
        if (turn != 0)
          moment += point.weight * turn *
                    multiplier.at(solved.state.multiplier, point.contact, point.t).normal;
      });
  return moment == 0 ? 0 : moment / squareOf(solved.space);
}

}  // namespace epafi::adaptivity
