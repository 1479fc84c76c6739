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

Vector turningTractions(const std::vector<Estimated>& states) {
  Vector moments(states.size());
  const contact::ContactBody& body = states.front().solved.problem;
  const bem::Space& space = body.space();
  if (space.rotation() == nullptr)
    return moments;
  const auto number = static_cast<int>(body.number());
  forEachSidePoint(
      body.multiplier(), body.opposite(),
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
        for (std::size_t k = 0; turn != 0 && k < states.size(); ++k)
          if (const Vector& lambda = states[k].solved.state.multiplier; !lambda.empty())
            moments[k] += point.weight * turn *
                          body.multiplier().at(lambda, point.contact, point.t).normal;
      });
  if (bem::largestEntry(moments) == 0)
    return moments;
  return bem::times(1 / squareOf(space), std::move(moments));
}

}  // namespace epafi::adaptivity
