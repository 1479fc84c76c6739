#include "bem/geometry/CurveTree.hpp"

#include <algorithm>
#include <utility>

namespace epafi::bem {

namespace {

/// The smallest disc that contains both.
Disc around(const Disc& a, const Disc& b) {
  const Vec2 way = b.middle - a.middle;
  const double distance = norm(way);
  if (distance + b.radius <= a.radius)
    return a;
  if (distance + a.radius <= b.radius)
    return b;
  const double radius = 0.5 * (distance + a.radius + b.radius);
  constexpr double rounding = 1 + 1e-14;
  return {a.middle + ((radius - a.radius) / distance) * way, rounding * radius};
}

}  // namespace

CurveTree::CurveTree(std::vector<Curve> curves) : curves_(std::move(curves)) {
  std::size_t leaves = 1;
  while (leaves < curves_.size())
    leaves *= 2;
  discs_.resize(2 * leaves - 1);
  if (!curves_.empty())
    enclose(0, {0, curves_.size()});
}

void CurveTree::enclose(std::size_t node, Range range) {
  if (range.isOne()) {
    discs_[node] = discOf(curves_[range.begin]);
    return;
  }
  enclose(2 * node + 1, {range.begin, range.middle()});
  enclose(2 * node + 2, {range.middle(), range.end});
  discs_[node] = around(discs_[2 * node + 1], discs_[2 * node + 2]);
}

CurveTree::Foot CurveTree::nearest(Vec2 x) const {
  Foot foot;
  approach(
      x, [&] { return foot.distance; },
      [&](std::size_t k) {
        const double t = std::clamp(curves_[k].seen(x).z.real(), -1.0, 1.0);
        if (const double distance = norm(x - curves_[k].point(t));
            distance < foot.distance)
          foot = {k, t, distance};
      });
  return foot;
}

}  // namespace epafi::bem
