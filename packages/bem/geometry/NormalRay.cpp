#include "bem/geometry/NormalRay.hpp"

#include "bem/geometry/Crossing.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <utility>

namespace epafi::bem {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Can a normal line of the side meet a curve in the disc?  True for any that does.
bool mayFace(const Curve& side, const Disc& disc) {
  constexpr double rounding = 1 + 1e-9;
  constexpr double ofAngles = 1e-14;
  const double radius = rounding * disc.radius + ofCoordinates;
  const Vec2 way = disc.middle - side.frame().middle;
  if (side.isStraight())
    return std::abs(dot(way, side.frame().tangent)) <= rounding * side.half() + radius;
  const Vec2 ray = disc.middle - side.centre();
  const double distance = norm(ray);
  return distance <= radius || std::atan2(std::abs(dot(side.frame().tangent, ray)),
                                          std::abs(dot(side.frame().normal, ray))) <=
                                   rounding * 0.5 * std::abs(side.angle()) +
                                       std::asin(radius / distance) + ofAngles;
}

/// Of two crossings with one curve.
bool isBetter(const Crossing& a, const Crossing& b, const Curve& curve) {
  if (isOn(a, curve) != isOn(b, curve))
    return isOn(a, curve);
  return isOn(a, curve) ? std::abs(a.distance) < std::abs(b.distance)
                        : std::abs(a.t) < std::abs(b.t);
}

/// Calls visit(s, n · n(t)) for the crossings of the line x + s n with the full line or circle of a
/// curve of curvature κ, normal m and middle y₀.  With w = x - y₀ they are
///
///   n · n(t) = o = ±√(1 - k²),  k = n × m + κ n × w,   κ s = o - h,  h = n · m + κ n · w,
///
/// and s = -g / (o + h),  g = 2 w · m + κ w · w, which holds for a line, too, and does not cancel.
template <class Visit>
void forEachCrossing(Vec2 x, Vec2 n, const Curve& curve, const Visit& visit) {
  constexpr double grazing = 1e-12;
  const double curvature = curve.curvature();
  const Vec2 normal = curve.frame().normal;
  const Vec2 w = x - curve.frame().middle;
  const double k = std::abs(cross(n, normal) + curvature * cross(n, w));
  const double h = dot(n, normal) + curvature * dot(n, w);
  const double g = 2 * dot(w, normal) + curvature * dot(w, w);
  const double root =
      curve.isStraight() ? h : std::sqrt(std::max(0.0, (1 - k) * (1 + k)));
  if (!(std::abs(root) > grazing))
    return;
  for (const double outward : {-root, root}) {
    if (curve.isStraight() && outward != h)
      continue;
    const double s = outward * h > 0 ? -g / (outward + h) : (outward - h) / curvature;
    visit(s, outward);
  }
}

Crossing crossingAt(Vec2 x, Vec2 n, double s, const Curve& curve) {
  return {s, curve.seen(x + s * n).z.real()};
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

/// Adds where normals of the side meet ends of a curve, or touch it; or where the curve's normals at its
/// ends meet the side.
void addEnds(const Curve& side, const Curve& curve, Normals along, Vector& ends) {
  if (along == Normals::Opposite) {
    for (const double t : {-1.0, 1.0})
      if (const auto end = crossing(curve.point(t), curve.normal(t), side))
        ends.push_back(end->t);
    return;
  }
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
        const double radius = rounding * disc.radius + ofCoordinates;
        const Vec2 way = disc.middle - x;
        const double along = dot(n, way);
        return !found && std::abs(cross(n, way)) <= radius && along >= first - radius &&
               along <= last + radius;
      },
      [&](std::size_t k) {
        const Curve& curve = curves.curves()[k];
        forEachCrossing(x, n, curve, [&](double s, double) {
          found =
              found || (s > first && s < last && isOn(crossingAt(x, n, s, curve), curve));
        });
      });
  return found;
}

}  // namespace

std::optional<Crossing> crossing(Vec2 x, Vec2 n, const Curve& curve) {
  std::optional<Crossing> best;
  forEachCrossing(x, n, curve, [&](double s, double outward) {
    if (outward >= 0)
      return;
    const Crossing found = crossingAt(x, n, s, curve);
    if (!best || isBetter(found, *best, curve))
      best = found;
  });
  return best;
}

std::optional<Crossing> across(Vec2 x, Vec2 n, const Curve& curve, Normals along) {
  if (along == Normals::Own)
    return crossing(x, n, curve);
  std::optional<Crossing> best;
  for (const double t : feetOn(curve, x)) {
    const Vec2 normal = curve.normal(t);
    const Crossing found{dot(x - curve.point(t), normal), t};
    if (dot(n, normal) < 0 && (!best || isBetter(found, *best, curve)))
      best = found;
  }
  return best;
}

std::vector<double> feetOn(const Curve& side, Vec2 y) {
  const double foot = side.seen(y).z.real();
  if (side.isStraight())
    return {foot};
  const double halfACircle =
      2 * boost::math::constants::pi<double>() / std::abs(side.angle());
  return {foot, foot > 0 ? foot - halfACircle : foot + halfACircle};
}

Visibility::Visibility(std::vector<Curve> own, std::vector<Curve> opposite,
                       double touching)
    : own_(std::move(own)), opposite_(std::move(opposite)), touching_(touching) {
  for (const Curve& curve : own_.curves())
    opposite_.search([&](const Disc& disc) { return disc.isNear(discOf(curve)); },
                     [&](std::size_t k) {
                       for (const Vec2 y : crossings(curve, opposite_.curves()[k]))
                         crossings_.push_back(y);
                     });
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
    body->search(
        [&](const Disc& disc) { return mayFace(side, disc); },
        [&](std::size_t k) { addEnds(side, body->curves()[k], Normals::Own, places); });
  for (const Vec2 y : crossings_)
    if (mayFace(side, {y, 0}))
      for (const double t : feetOn(side, y))
        places.push_back(t);
}

std::optional<FacedPoint> faced(const Curve& side, double t, const CurveTree& opposite,
                                const Visibility& visibility, Normals along) {
  const Vec2 x = side.point(t);
  const Vec2 n = side.normal(t);
  std::optional<FacedPoint> best;
  const auto visit = [&](std::size_t k) {
    const Curve& curve = opposite.curves()[k];
    const auto here = across(x, n, curve, along);
    if (here && isOn(*here, curve) &&
        (!best || std::abs(here->distance) < std::abs(best->crossing.distance)) &&
        visibility.sees(x, sightLine(n, curve, here->t, along), here->distance))
      best = FacedPoint{static_cast<int>(k), *here};
  };
  if (along == Normals::Own)
    opposite.search(
        [&](const Disc& disc) {
          constexpr double rounding = 1 + 1e-9;
          return std::abs(cross(n, disc.middle - x)) <=
                 rounding * disc.radius + ofCoordinates;
        },
        visit);
  else
    opposite.approach(
        x, [&] { return best ? std::abs(best->crossing.distance) : infinite; }, visit);
  return best;
}

namespace {

/// The stretches of a side between places where what it sees may change, and the farthest that their
/// middles see; infinite where some of them see nothing.
std::pair<std::vector<Facing>, double> between(Vector places, const Curve& side,
                                               const CurveTree& opposite,
                                               const Visibility& visibility,
                                               Normals along) {
  constexpr double tiny = 1e-12;  // of an element: rounding of two ends that meet
  places.insert(places.end(), {-1, 1});
  std::sort(places.begin(), places.end());
  std::vector<Facing> stretches;
  double farthest = 0;
  double begin = -1;
  for (const double end : places) {
    if (!(end >= -1 && end <= 1) || end - begin < tiny || (end < 1 && 1 - end < tiny))
      continue;
    const auto found = faced(side, 0.5 * (begin + end), opposite, visibility, along);
    farthest = std::max(farthest, found ? std::abs(found->crossing.distance) : infinite);
    if (found && !stretches.empty() && stretches.back().end == begin &&
        stretches.back().curve == found->curve)
      stretches.back().end = end;
    else if (found)
      stretches.push_back({begin, end, found->curve});
    begin = end;
  }
  return {std::move(stretches), farthest};
}

}  // namespace

std::vector<Facing> facing(const Curve& side, const CurveTree& opposite,
                           const Visibility& visibility, Normals along) {
  Vector changes;
  visibility.addChanges(side, changes);
  if (along == Normals::Own) {
    opposite.search(
        [&](const Disc& disc) { return mayFace(side, disc); },
        [&](std::size_t k) { addEnds(side, opposite.curves()[k], along, changes); });
    return between(std::move(changes), side, opposite, visibility, along).first;
  }
  // what is seen is the nearest, and as far from the middle of the side as from all of it, up to
  // this; if that is not so, all that is opposite counts
  const double slack = 4 * side.half();
  const auto middle = faced(side, 0, opposite, visibility, along);
  double reach = middle ? std::abs(middle->crossing.distance) + slack : infinite;
  while (true) {
    Vector places = changes;
    opposite.approach(
        side.point(0), [&] { return reach; },
        [&](std::size_t k) { addEnds(side, opposite.curves()[k], along, places); });
    auto [stretches, farthest] =
        between(std::move(places), side, opposite, visibility, along);
    if (reach == infinite || farthest + 0.75 * slack <= reach)
      return stretches;
    reach = infinite;
  }
}

}  // namespace epafi::bem
