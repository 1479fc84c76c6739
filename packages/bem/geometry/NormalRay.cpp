#include "bem/geometry/NormalRay.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

/// The parameter of the point of an arc in a direction from its centre.
double parameterOf(const Curve& arc, Vec2 direction) {
  // from the centre to y(0) it is the normal, inward where the arc turns right
  const Vec2 middle = (arc.curvature() > 0 ? 1 : -1) * turnRight(arc.frame().tangent);
  return std::atan2(cross(middle, direction), dot(middle, direction)) /
         (0.5 * arc.angle());
}

/// Can a normal line of the side meet the curve?  True for any that does.
bool mayFace(const Curve& side, const Curve& curve) {
  constexpr double rounding = 1 + 1e-9;
  const double radius = rounding * curve.half();
  const Vec2 way = curve.frame().middle - side.frame().middle;
  if (side.isStraight())
    return std::abs(dot(way, side.frame().tangent)) <= rounding * side.half() + radius;
  const Vec2 ray = curve.frame().middle - side.centre();
  const double distance = norm(ray);
  return distance <= radius ||
         std::atan2(std::abs(dot(side.frame().tangent, ray)),
                    std::abs(dot(side.frame().normal, ray))) <=
             rounding * 0.5 * std::abs(side.angle()) + std::asin(radius / distance);
}

bool isBetter(const Crossing& a, const Crossing& b) {
  if (isOn(a) != isOn(b))
    return isOn(a);
  return isOn(a) ? std::abs(a.distance) < std::abs(b.distance)
                 : std::abs(a.t) < std::abs(b.t);
}

std::optional<Crossing> crossingOfSegment(Vec2 x, Vec2 n, const Curve& curve) {
  const double facing = dot(n, curve.frame().normal);
  if (!(facing < -1e-12))
    return {};
  const Vec2 way = curve.frame().middle - x;
  const double s = dot(way, curve.frame().normal) / facing;
  return Crossing{s, dot(s * n - way, curve.frame().tangent) / curve.half()};
}

std::optional<Crossing> crossingOfArc(Vec2 x, Vec2 n, const Curve& curve) {
  const Vec2 centre = curve.centre();
  const double radius = 1 / std::abs(curve.curvature());
  const Vec2 from = x - centre;
  const double half = dot(n, from);
  // (half + s)² = radius² - (the line's distance from the centre)²
  const double aside = cross(n, from);
  const double square = (radius - std::abs(aside)) * (radius + std::abs(aside));
  if (!(square > 0))
    return {};
  std::optional<Crossing> best;
  for (const double root : {-std::sqrt(square), std::sqrt(square)}) {
    const double s = root - half;
    const Vec2 direction = from + s * n;
    const double outward = (curve.curvature() > 0 ? 1 : -1) * dot(n, direction) / radius;
    if (!(outward < -1e-12))
      continue;
    const Crossing found{s, parameterOf(curve, direction)};
    if (!best || isBetter(found, *best))
      best = found;
  }
  return best;
}

/// Where normals of the side touch an arc.
void addGrazes(const Curve& side, const Curve& arc, Vector& feet) {
  const Vec2 centre = arc.centre();
  const double radius = 1 / std::abs(arc.curvature());
  std::vector<Vec2> touched;
  if (side.isStraight()) {
    for (const double sign : {-1.0, 1.0})
      touched.push_back(centre + sign * radius * side.frame().tangent);
  } else {
    const Vec2 way = centre - side.centre();
    const double distance = norm(way);
    if (!(distance > radius))
      return;
    const double sine = radius / distance;
    const double cosine = std::sqrt(1 - sine * sine);
    for (const double sign : {-1.0, 1.0})
      touched.push_back(side.centre() +
                        cosine * (cosine * way + sign * sine * turnLeft(way)));
  }
  for (const Vec2 y : touched)
    feet.push_back(footOn(side, y));
}

}  // namespace

std::optional<Crossing> crossing(Vec2 x, Vec2 n, const Curve& curve) {
  return curve.isStraight() ? crossingOfSegment(x, n, curve) : crossingOfArc(x, n, curve);
}

double footOn(const Curve& side, Vec2 y) {
  if (side.isStraight()) {
    const Vec2 fromStart = y - side.from();
    const Vec2 fromEnd = y - side.to();
    const double before = dot(fromStart, side.frame().tangent) / side.half();
    const double behind = dot(fromEnd, side.frame().tangent) / side.half();
    return std::abs(before) < std::abs(behind) ? before - 1 : behind + 1;
  }
  return parameterOf(side, y - side.centre());
}

std::vector<Facing> facing(const Curve& side, const std::vector<Curve>& opposite,
                           double reach) {
  constexpr double tiny = 1e-12;  // of an element: rounding of two ends that meet
  Vector ends = {-1, 1};
  std::vector<std::size_t> candidates;
  for (std::size_t k = 0; k < opposite.size(); ++k) {
    const Curve& curve = opposite[k];
    if (!mayFace(side, curve))
      continue;
    candidates.push_back(k);
    ends.push_back(footOn(side, curve.from()));
    ends.push_back(footOn(side, curve.to()));
    if (!curve.isStraight())
      addGrazes(side, curve, ends);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::remove_if(ends.begin(), ends.end(),
                            [](double t) { return !(t >= -1 && t <= 1); }),
             ends.end());
  std::vector<Facing> stretches;
  double begin = -1;
  for (const double end : ends) {
    if (end - begin < tiny || (end < 1 && 1 - end < tiny))
      continue;
    const double middle = 0.5 * (begin + end);
    const Vec2 x = side.point(middle);
    const Vec2 n = side.normal(middle);
    std::optional<Crossing> best;
    int found = -1;
    for (const std::size_t k : candidates) {
      const auto here = crossing(x, n, opposite[k]);
      if (here && isOn(*here) && std::abs(here->distance) <= reach &&
          (!best || isBetter(*here, *best))) {
        best = here;
        found = static_cast<int>(k);
      }
    }
    if (best && !stretches.empty() && stretches.back().end == begin &&
        stretches.back().curve == found)
      stretches.back().end = end;
    else if (best)
      stretches.push_back({begin, end, found});
    begin = end;
  }
  return stretches;
}

}  // namespace epafi::bem
