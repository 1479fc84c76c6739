#include "bem/moments/PairOrder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::bem {

namespace {

/// Smallest z (sum of the focal distances over the length) for which `base` points give
/// 1e-12, without the part that pays for the polynomials.
struct OrderTable {
  double smallestZ[largestSmoothOrder + 1] = {};
  OrderTable() {
    const double digits = std::log(1e12);
    smallestZ[0] = std::numeric_limits<double>::infinity();
    for (int base = 1; base <= largestSmoothOrder; ++base) {
      const double r = std::exp(digits / (2 * base));
      smallestZ[base] = 0.5 * (r + 1 / r);
    }
  }
};

// in outline diameters nothing overflows, and hypot costs as much as a whole far pair
double length(Vec2 a) { return std::sqrt(dot(a, a)); }

/// min over y in `source` of (|y-e0| + |y-e1|) / h, e0 and e1 the ends of E.
/// [doc/theory/operators.md]
double focalRatio(const Element& e, const Element& source, Vec2 middle) {
  // in a frame with E's middle as origin: `middle` is the source's middle there
  const Vec2 e1 = e.half * e.segment().tangent;
  const Vec2 e0 = -e1;
  const auto foot = [&](Vec2 x) { return dot(x - middle, source.segment().tangent); };
  const auto off = [&](Vec2 x) {
    return std::abs(dot(x - middle, source.segment().normal));
  };
  const double d0 = off(e0);
  const double d1 = off(e1);
  double t = 0;
  if (d0 + d1 > 1e-14 * e.half)
    t = (foot(e0) * d1 + foot(e1) * d0) / (d0 + d1);
  else
    t = foot({0, 0});
  t = std::clamp(t, -source.half, source.half);
  const Vec2 y = middle + t * source.segment().tangent;
  return (length(y - e0) + length(y - e1)) / (2 * e.half);
}

double distanceToSegment(Vec2 x, Vec2 middle, const Element& segment) {
  const double t =
      std::clamp(dot(x - middle, segment.segment().tangent), -segment.half, segment.half);
  return length(x - middle - t * segment.segment().tangent);
}

/// Distance of two elements that do not cross; `w` from F's middle to E's.
double gap(const Element& e, const Element& f, Vec2 w) {
  const Vec2 he = e.half * e.segment().tangent;
  const Vec2 hf = f.half * f.segment().tangent;
  return std::min({distanceToSegment(w - he, {0, 0}, f),
                   distanceToSegment(w + he, {0, 0}, f), distanceToSegment(-hf, w, e),
                   distanceToSegment(hf, w, e)});
}

}  // namespace

int smoothOrder(double z) {
  static const OrderTable table;
  int base = 1;
  while (base < largestSmoothOrder && table.smallestZ[base] > z)
    ++base;
  return base;
}

bool isNear(const Mesh& mesh, int ie, int jf, Vec2 w, PairOrder& order) {
  const Element& e = mesh[ie];
  const Element& f = mesh[jf];
  if (ie == jf || e.next == jf || f.next == ie)
    return true;
  const double distance = length(w);
  const double larger = std::max(e.half, f.half);
  if (distance - e.half - f.half < larger && gap(e, f, w) < larger)
    return true;
  // |y-e0| + |y-e1| >= 2 |y-m|: a bound that costs no projections
  double zE = (distance - f.half) / e.half;
  double zF = (distance - e.half) / f.half;
  if (zE < 4)
    zE = std::max(zE, focalRatio(e, f, -w));
  if (zF < 4)
    zF = std::max(zF, focalRatio(f, e, w));
  order = {smoothOrder(zE), smoothOrder(zF)};
  return false;
}

}  // namespace epafi::bem
