#include "bem/geometry/NormalRay.hpp"

#include "bem/geometry/Crossing.hpp"

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

/// Can a normal line of the side meet a curve in the disc?  True for any that does.
bool mayFace(const Curve& side, const Disc& disc) {
  constexpr double rounding = 1 + 1e-9;
  const double radius = rounding * disc.radius;
  const Vec2 way = disc.middle - side.frame().middle;
  if (side.isStraight())
    return std::abs(dot(way, side.frame().tangent)) <= rounding * side.half() + radius;
  const Vec2 ray = disc.middle - side.centre();
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

/// Calls visit(crossing, n · n(t)) for those of the line x + s n with the full line or circle of a
/// curve.
template <class Visit>
void forEachCrossing(Vec2 x, Vec2 n, const Curve& curve, const Visit& visit) {
  constexpr double grazing = 1e-12;
  if (curve.isStraight()) {
    const double outward = dot(n, curve.frame().normal);
    if (!(std::abs(outward) > grazing))
      return;
    const Vec2 way = curve.frame().middle - x;
    const double s = dot(way, curve.frame().normal) / outward;
    visit(Crossing{s, dot(s * n - way, curve.frame().tangent) / curve.half()}, outward);
    return;
  }
  const Vec2 centre = curve.centre();
  const double radius = 1 / std::abs(curve.curvature());
  const Vec2 from = x - centre;
  const double half = dot(n, from);
  // (half + s)² = radius² - (the line's distance from the centre)²
  const double aside = cross(n, from);
  const double square = (radius - std::abs(aside)) * (radius + std::abs(aside));
  if (!(square > 0))
    return;
  for (const double root : {-std::sqrt(square), std::sqrt(square)}) {
    const double s = root - half;
    const Vec2 direction = from + s * n;
    const double outward = (curve.curvature() > 0 ? 1 : -1) * dot(n, direction) / radius;
    if (std::abs(outward) > grazing)
      visit(Crossing{s, parameterOf(curve, direction)}, outward);
  }
}

/// Where normals of the side touch an arc.
std::vector<Vec2> grazes(const Curve& side, const Curve& arc) {
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
      return touched;
    const double sine = radius / distance;
    const double cosine = std::sqrt(1 - sine * sine);
    for (const double sign : {-1.0, 1.0})
      touched.push_back(side.centre() +
                        cosine * (cosine * way + sign * sine * turnLeft(way)));
  }
  return touched;
}

/// Adds where normals of the side meet ends of a curve, or touch it.
void addEnds(const Curve& side, const Curve& curve, Vector& ends) {
  std::vector<Vec2> points = {curve.from(), curve.to()};
  if (!curve.isStraight())
    for (const Vec2 y : grazes(side, curve))
      points.push_back(y);
  for (const Vec2 y : points)
    for (const double t : feetOn(side, y))
      ends.push_back(t);
}

/// Does the line x + s n cross a curve within an interval of s?
bool crosses(Vec2 x, Vec2 n, double first, double last, const CurveTree& curves) {
  bool found = false;
  curves.search(
      [&](const Disc& disc) {
        constexpr double rounding = 1 + 1e-9;
        const double radius = rounding * disc.radius;
        const Vec2 way = disc.middle - x;
        const double along = dot(n, way);
        return !found && std::abs(cross(n, way)) <= radius && along >= first - radius &&
               along <= last + radius;
      },
      [&](std::size_t k) {
        forEachCrossing(x, n, curves.curves()[k], [&](const Crossing& here, double) {
          found = found || (isOn(here) && here.distance > first && here.distance < last);
        });
      });
  return found;
}

}  // namespace

std::optional<Crossing> crossing(Vec2 x, Vec2 n, const Curve& curve) {
  std::optional<Crossing> best;
  forEachCrossing(x, n, curve, [&](const Crossing& found, double outward) {
    if (outward < 0 && (!best || isBetter(found, *best)))
      best = found;
  });
  return best;
}

std::vector<double> feetOn(const Curve& side, Vec2 y) {
  if (side.isStraight()) {
    const Vec2 fromStart = y - side.from();
    const Vec2 fromEnd = y - side.to();
    const double before = dot(fromStart, side.frame().tangent) / side.half();
    const double behind = dot(fromEnd, side.frame().tangent) / side.half();
    return {std::abs(before) < std::abs(behind) ? before - 1 : behind + 1};
  }
  const Vec2 ray = y - side.centre();
  return {parameterOf(side, ray), parameterOf(side, -ray)};
}

bool Visibility::sees(Vec2 x, Vec2 n, double s) const {
  if (std::abs(s) <= touching_)
    return true;
  const Vec2 way = s > 0 ? n : -n;
  const double distance = std::abs(s);
  // what ends with the opposite body, as flush sides do, hides it
  return !crosses(x, way, touching_, distance + touching_, own_) &&
         !crosses(x, way, touching_, distance - touching_, opposite_);
}

void Visibility::addChanges(const Curve& side, Vector& places) const {
  for (const CurveTree* body : {&own_, &opposite_})
    body->search([&](const Disc& disc) { return mayFace(side, disc); },
                 [&](std::size_t k) { addEnds(side, body->curves()[k], places); });
  // where the side comes into the opposite body, or leaves it
  const Disc own = discOf(side);
  opposite_.search([&](const Disc& disc) { return disc.isNear(own); },
                   [&](std::size_t k) {
                     for (const Vec2 y : crossings(side, opposite_.curves()[k]))
                       places.push_back(feetOn(side, y).front());
                   });
}

std::optional<FacedPoint> faced(const Curve& side, double t, const CurveTree& opposite,
                                const Visibility& visibility) {
  const Vec2 x = side.point(t);
  const Vec2 n = side.normal(t);
  std::optional<FacedPoint> best;
  opposite.search(
      [&](const Disc& disc) {
        constexpr double rounding = 1 + 1e-9;
        return std::abs(cross(n, disc.middle - x)) <= rounding * disc.radius;
      },
      [&](std::size_t k) {
        const auto here = crossing(x, n, opposite.curves()[k]);
        if (here && isOn(*here) && (!best || isBetter(*here, best->crossing)) &&
            visibility.sees(x, n, here->distance))
          best = FacedPoint{static_cast<int>(k), *here};
      });
  return best;
}

std::vector<Facing> facing(const Curve& side, const CurveTree& opposite,
                           const Visibility& visibility) {
  constexpr double tiny = 1e-12;  // of an element: rounding of two ends that meet
  Vector ends = {-1, 1};
  opposite.search([&](const Disc& disc) { return mayFace(side, disc); },
                  [&](std::size_t k) { addEnds(side, opposite.curves()[k], ends); });
  visibility.addChanges(side, ends);
  std::sort(ends.begin(), ends.end());
  ends.erase(std::remove_if(ends.begin(), ends.end(),
                            [](double t) { return !(t >= -1 && t <= 1); }),
             ends.end());
  std::vector<Facing> stretches;
  double begin = -1;
  for (const double end : ends) {
    if (end - begin < tiny || (end < 1 && 1 - end < tiny))
      continue;
    const auto found = faced(side, 0.5 * (begin + end), opposite, visibility);
    if (found && !stretches.empty() && stretches.back().end == begin &&
        stretches.back().curve == found->curve)
      stretches.back().end = end;
    else if (found)
      stretches.push_back({begin, end, found->curve});
    begin = end;
  }
  return stretches;
}

}  // namespace epafi::bem
