#include "contact/opposite/Direction.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::contact {

using bem::Vec2;

namespace {

/// How far it is to where the normal has turned by an angle; infinite if it never does.
double wayToTurn(const SideShape& side, double angle) {
  const bem::Continuation& way = angle > 0 ? side.beyond.after : side.beyond.before;
  return way.length + std::abs(angle) / way.curvature;
}

/// The curvature, or that which a corner near by amounts to.
double apparentCurvature(const SideShape& side, double angle) {
  constexpr double near = 0.25;    // of the line or circle
  constexpr double least = 1e-12;  // of the line or circle
  const double curvature = std::abs(side.curvature);
  if (angle == 0)
    return curvature;
  const double whole = side.beyond.before.length + side.beyond.after.length;
  const double fading =
      1 - (angle > 0 ? side.beyond.after : side.beyond.before).length / (near * whole);
  const double way = std::max(wayToTurn(side, angle), least * whole);
  return fading > 0 ? std::max(curvature, fading * fading * std::abs(angle) / way)
                    : curvature;
}

/// Of an arc of more than a radian: others leave their place when they turn about their centres; of
/// half a body 0, whose whole does not turn.
double turnAlong(const SideShape& side, Vec2 direction) {
  const double angle =
      std::abs(side.curvature) * (side.beyond.before.length + side.beyond.after.length);
  return angle < 1 || !side.beyond.turns
             ? 0
             : dot(turnLeft(side.normal), direction) / side.curvature;
}

}  // namespace

SideShape shapeAt(const bem::Curve& curve, Vec2 normal, const bem::Continuations& beyond,
                  double t) {
  const double half = curve.half();
  return {normal, curve.curvature(),
          beyond.ofPart({half * (1 + t), 0}, {0, half * (1 - t)})};
}

Direction directionBetween(const SideShape& own, const SideShape& opposite) {
  constexpr double parallel = 1e-12;
  const Vec2 other = -opposite.normal;
  const double angle = std::atan2(cross(own.normal, other), dot(own.normal, other));
  double ofOwn = 1;
  double ofOther = 0;
  if (own.curvature != 0 || opposite.curvature != 0) {
    ofOwn = apparentCurvature(opposite, -angle);
    ofOther = apparentCurvature(own, angle);
    if (own.curvature < 0 || opposite.curvature < 0) {
      ofOwn = std::sqrt(ofOwn);
      ofOther = std::sqrt(ofOther);
    }
  } else if (std::abs(angle) > parallel) {
    constexpr double tiny = 1e-100;  // where corner meets corner
    const double way = wayToTurn(own, angle) + tiny;
    const double otherWay = wayToTurn(opposite, -angle) + tiny;
    if (std::isfinite(way)) {
      ofOwn = std::isfinite(otherWay) ? way : 0;
      ofOther = std::isfinite(otherWay) ? otherWay : 1;
    }
  }
  const Vec2 sum = ofOwn * own.normal + ofOther * other;
  Direction result;
  result.angle = angle;
  if (own.curvature > 0 && opposite.curvature > 0)
    result.parting =
        own.curvature * opposite.curvature / (own.curvature + opposite.curvature);
  result.unit = (1 / norm(sum)) * sum;
  if (ofOther == 0)
    result.unit = own.normal;
  result.ownTurn = turnAlong(own, result.unit);
  result.oppositeTurn = turnAlong(opposite, result.unit);
  return result;
}

}  // namespace epafi::contact
