#include "bem/geometry/Crossing.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <utility>

namespace epafi::bem {

namespace {

constexpr double pi = boost::math::constants::pi<double>();

bool properlyCross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto opposite = [](double s, double t) {
    return (s < 0 && t > 0) || (s > 0 && t < 0);
  };
  return opposite(cross(b - a, c - a), cross(b - a, d - a)) &&
         opposite(cross(d - c, a - c), cross(d - c, b - c));
}

double radiusOf(const Curve& arc) { return std::abs(1 / arc.curvature()); }

/// Where the circles or lines of both cross.
std::vector<Vec2> crossingsOfWholes(const Curve& a, const Curve& b) {
  if (a.isStraight())
    return b.isStraight() ? std::vector<Vec2>() : crossingsOfWholes(b, a);
  const Vec2 centre = a.centre();
  const double radius = radiusOf(a);
  Vec2 foot;
  Vec2 along;
  if (b.isStraight()) {
    along = b.frame().tangent;
    foot = b.frame().middle + dot(centre - b.frame().middle, along) * along;
  } else {
    const Vec2 apart = b.centre() - centre;
    const double distance = norm(apart);
    if (!(distance > 1e-14 * radius))
      return {};
    const Vec2 direction = (1 / distance) * apart;
    const double other = radiusOf(b);
    foot = centre +
           0.5 * (distance + (radius - other) * (radius + other) / distance) * direction;
    along = turnLeft(direction);
  }
  const double depth = norm(foot - centre);
  const double reach = (radius - depth) * (radius + depth);
  const double side = std::sqrt(std::max(0.0, reach));
  // circles that miss each other by rounding have their common normal there
  if (reach < -1e-6 * radius * radius)
    return {};
  return {foot + side * along, foot - side * along};
}

/// The crossing next to a point by Newton's method, from coordinates that are as accurate
/// as the curves; false without one on both.
bool crossNear(const Curve& a, const Curve& b, Vec2 start, Vec2& crossing) {
  double s = a.seen(start).z.real();
  double t = b.seen(start).z.real();
  Vec2 apart;
  for (int step = 0; step < 8; ++step) {
    if (!(std::abs(s) < 3) || !(std::abs(t) < 3))
      return false;
    apart = a.point(s) - b.point(t);
    const Vec2 slopeA = a.half() * a.tangent(s);
    const Vec2 slopeB = b.half() * b.tangent(t);
    const double determinant = cross(slopeA, slopeB);
    if (std::abs(determinant) < 1e-9 * a.half() * b.half())
      return false;
    s -= cross(apart, slopeB) / determinant;
    t -= cross(apart, slopeA) / determinant;
  }
  crossing = a.point(s);
  return norm(apart) <= 1e-13 * (a.half() + b.half()) && std::abs(s) <= 1 &&
         std::abs(t) <= 1;
}

/// Points of a at which b may be nearest: its ends, and feet of common normals.
std::vector<Vec2> candidates(const Curve& a, const Curve& b) {
  std::vector<Vec2> points = {a.from(), a.to()};
  const auto addFoot = [&](Vec2 direction) {
    const double length = norm(direction);
    if (!(length > 0))
      return;
    const Vec2 centre = a.centre();
    for (const double side : {1.0, -1.0}) {
      const Vec2 foot = centre + (side * radiusOf(a) / length) * direction;
      const double t = a.seen(foot).z.real();
      if (std::abs(t) < 1)
        points.push_back(a.point(t));
    }
  };
  if (!a.isStraight())
    addFoot(b.isStraight() ? b.frame().normal : b.centre() - a.centre());
  return points;
}

/// Do they cross, or come as close as this, at a point that counts?
template <class Counts>
bool meetWhere(const Curve& a, const Curve& b, double tolerance, const Counts& counts) {
  const std::vector<Vec2> found = crossings(a, b);
  if (std::any_of(found.begin(), found.end(), counts))
    return true;
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const Vec2 x : candidates(*from, *to))
      if (counts(x) && to->distance(x) <= tolerance)
        return true;
  return false;
}

/// Parts between which y rises or falls all the way, as places on the curve.
std::vector<double> monotoneCuts(const Curve& curve) {
  std::vector<double> cuts = {-1};
  const double alpha = 0.5 * curve.angle();
  if (alpha != 0) {
    const Vec2 tangent = curve.frame().tangent;
    const double direction = std::atan2(tangent.y, tangent.x);
    for (int k = -3; k <= 3; ++k) {
      const double t = (k * pi - direction) / alpha;
      if (t > -1 && t < 1)
        cuts.push_back(t);
    }
  }
  cuts.push_back(1);
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

/// Does a ray from p to the right cross the monotone part between two places, at the points
/// a and b?
bool rayCrosses(Vec2 p, const Curve& curve, double s, Vec2 a, double t, Vec2 b) {
  if ((a.y > p.y) == (b.y > p.y))
    return false;
  if (curve.isStraight()) {
    const double side = cross(b - a, p - a);
    return b.y > a.y ? side > 0 : side < 0;
  }
  for (int step = 0; step < 60; ++step) {
    const double middle = 0.5 * (s + t);
    const Vec2 x = curve.point(middle);
    ((x.y > p.y) == (a.y > p.y) ? s : t) = middle;
  }
  return curve.point(0.5 * (s + t)).x > p.x;
}

}  // namespace

std::vector<Vec2> crossings(const Curve& a, const Curve& b) {
  std::vector<Vec2> found;
  for (const Vec2 start : crossingsOfWholes(a, b)) {
    Vec2 crossing;
    if (crossNear(a, b, start, crossing))
      found.push_back(crossing);
  }
  if (a.isStraight() && b.isStraight() &&
      properlyCross(a.from(), a.to(), b.from(), b.to())) {
    const Vec2 way = b.from() - a.from();
    const Vec2 along = a.to() - a.from();
    const Vec2 across = b.to() - b.from();
    found.push_back(a.from() + (cross(way, across) / cross(along, across)) * along);
  }
  return found;
}

bool meet(const Curve& a, const Curve& b, double tolerance) {
  const Vec2 apart = a.frame().middle - b.frame().middle;
  return norm(apart) <= a.half() + b.half() + tolerance &&
         meetWhere(a, b, tolerance, [](Vec2) { return true; });
}

bool meetElsewhere(const Curve& a, const Curve& b, double tolerance, double blind) {
  std::vector<Vec2> common;
  for (const Vec2 x : {a.from(), a.to()})
    for (const Vec2 y : {b.from(), b.to()})
      if (x == y)
        common.push_back(x);
  const auto isElsewhere = [&](Vec2 x) {
    return std::all_of(common.begin(), common.end(),
                       [&](Vec2 y) { return norm(x - y) > blind; });
  };
  if (meetWhere(a, b, tolerance, isElsewhere))
    return true;
  const auto runsBack = [](Vec2 arriving, Vec2 leaving) {
    return dot(arriving, leaving) < 0 && std::abs(cross(arriving, leaving)) < 1e-12;
  };
  return (a.to() == b.from() && runsBack(a.tangent(1), b.tangent(-1))) ||
         (b.to() == a.from() && runsBack(b.tangent(1), a.tangent(-1)));
}

bool inside(Vec2 p, const CurveTree& loops) {
  bool odd = false;
  const auto mayBeCrossed = [p](const Disc& disc) {
    constexpr double rounding = 1e-12;
    const double radius = disc.radius + rounding * (disc.radius + norm(disc.middle));
    return std::abs(disc.middle.y - p.y) <= radius && disc.middle.x + radius >= p.x;
  };
  loops.search(mayBeCrossed, [&](std::size_t number) {
    const Curve& curve = loops.curves()[number];
    const std::vector<double> cuts = monotoneCuts(curve);
    // at the ends the curve's own points, which the neighbours share
    const auto place = [&](std::size_t k) {
      return k == 0 ? curve.from()
                    : (k + 1 == cuts.size() ? curve.to() : curve.point(cuts[k]));
    };
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
      if (rayCrosses(p, curve, cuts[k], place(k), cuts[k + 1], place(k + 1)))
        odd = !odd;
  });
  return odd;
}

std::vector<Vec2> chords(const Curve& curve) {
  const int count = curve.isStraight() ? 1 : 32;
  std::vector<Vec2> points;
  for (int k = 0; k <= count; ++k)
    points.push_back(curve.point(2.0 * k / count - 1));
  return points;
}

std::vector<Vec2> extent(const Curve& curve) {
  std::vector<Vec2> points = chords(curve);
  points.pop_back();
  if (curve.isStraight())
    return points;
  for (int k = -6; k <= 6; ++k) {
    const Vec2 tangent = curve.frame().tangent;
    const double t =
        (0.5 * pi * k - std::atan2(tangent.y, tangent.x)) / (0.5 * curve.angle());
    if (t > -1 && t < 1)
      points.push_back(curve.point(t));
  }
  return points;
}

double twiceAreaBesideChord(const Curve& curve) {
  const double angle = curve.angle();
  if (std::abs(angle) < 1e-2)  // (θ - sin θ) / (θ/2)²
    return curve.half() * curve.half() * 2 * angle / 3 * (1 - angle * angle / 20);
  const double radius = 1 / curve.curvature();
  return radius * radius * (angle - std::sin(angle));
}

}  // namespace epafi::bem
