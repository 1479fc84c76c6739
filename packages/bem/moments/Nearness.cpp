#include "bem/moments/Nearness.hpp"

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

/// How an arc is looked at: so many points a side of its middle.
constexpr int samplesASide = 4;

/// Distance of two elements at points a quarter of half a length apart: 3 % too large where
/// it is half the larger one's length.
double sampledGap(const Element& e, const Element& f, Vec2 w) {
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = -samplesASide; i <= samplesASide; ++i) {
    const Vec2 x = w + e.curve.fromMiddle(i / static_cast<double>(samplesASide));
    for (int j = -samplesASide; j <= samplesASide; ++j)
      smallest =
          std::min(smallest,
                   length(x - f.curve.fromMiddle(j / static_cast<double>(samplesASide))));
  }
  return smallest;
}

/// Half the sum of the distances from both ends of [-1, 1] to the nearer places of a
/// target: its own, or the same on another turn of the circle.
double focal(const RelativeTarget& x, double alpha) {
  const double own = 0.5 * (std::abs(x.zMinus1) + std::abs(x.zPlus1));
  if (alpha == 0)
    return own;
  const double turn = std::copysign(2 * 3.14159265358979 / std::abs(alpha), x.z.real());
  return std::min(own, 0.5 * (std::abs(x.zMinus1 - turn) + std::abs(x.zPlus1 - turn)));
}

/// The same as focalRatio in the parameter's plane; `w` from the middle of the source to
/// E's.
double arcRatio(const Element& e, const Element& source, Vec2 w) {
  const double alpha = 0.5 * e.curve.angle();
  const Vec2 start = -e.curve.fromMiddle(-1);
  const Vec2 end = -e.curve.fromMiddle(1);
  double z = std::numeric_limits<double>::infinity();
  for (int i = -samplesASide; i <= samplesASide; ++i) {
    const Vec2 y = source.curve.fromMiddle(i / static_cast<double>(samplesASide)) - w;
    z = std::min(z, focal(e.curve.seen(y + start, y + end), alpha));
  }
  constexpr double betweenSamples = 0.97;
  return betweenSamples * z;
}

/// |t₀| of a target at a distance from an arc's middle, in half lengths, is at least this.
double smallestPlace(double distance, double alpha) {
  return alpha == 0
             ? distance
             : std::log1p(std::abs(alpha) * std::max(distance, 0.0)) / std::abs(alpha);
}

/// Largest |α| for which n points integrate e^{2iαt} to 1e-14.
struct TurningTable {
  double largestAlpha[largestSmoothOrder + 1] = {};
  TurningTable() {
    constexpr double wanted = 1e-14;
    double factor = 2;
    for (int n = 1; n <= largestSmoothOrder; ++n) {
      // error of n points: 2^(2n+1) n!⁴ / ((2n+1) (2n)!³) (2α)^(2n)
      const double k = n;
      factor *= 4 * std::pow(k, 4) * (2 * k - 1) /
                ((2 * k + 1) * std::pow(2 * k * (2 * k - 1), 3));
      largestAlpha[n] = 0.5 * std::pow(wanted / factor, 0.5 / k);
    }
  }
};

int turningOrder(double alpha) {
  static const TurningTable table;
  int n = 1;
  while (n < largestSmoothOrder && table.largestAlpha[n] < std::abs(alpha))
    ++n;
  return n;
}

int arcOrder(double z, double alpha) {
  return alpha == 0 ? smoothOrder(z)
                    : std::min(std::max(smoothOrder(z) + 1, turningOrder(alpha)),
                               largestSmoothOrder);
}

}  // namespace

int smoothOrder(double z) {
  static const OrderTable table;
  int base = 1;
  while (base < largestSmoothOrder && table.smallestZ[base] > z)
    ++base;
  return base;
}

int farOrder(double angle, double distance) {
  return arcOrder(smallestPlace(distance, 0.5 * angle), 0.5 * angle);
}

// In one order, so that rounding cannot call a pair near once and far once.
Nearness nearness(const Mesh& mesh, int ie, int jf, Vec2 w) {
  if (ie < jf) {
    const Nearness swapped = nearness(mesh, jf, ie, -w);
    return {swapped.inner, swapped.outer};
  }
  const Element& e = mesh[ie];
  const Element& f = mesh[jf];
  if (ie == jf || e.next == jf || f.next == ie)
    return {};
  const double alphaE = 0.5 * e.curve.angle();
  const double alphaF = 0.5 * f.curve.angle();
  const bool areStraight = alphaE == 0 && alphaF == 0;
  const double distance = length(w);
  const double larger = std::max(e.half, f.half);
  if (distance - e.half - f.half < larger &&
      (areStraight ? gap(e, f, w) : sampledGap(e, f, w)) < larger)
    return {};
  // |y-e0| + |y-e1| >= 2 |y-m|: a bound that costs no projections
  double zE = smallestPlace((distance - f.half) / e.half, alphaE);
  double zF = smallestPlace((distance - e.half) / f.half, alphaF);
  if (zE < 4)
    zE = std::max(zE, areStraight ? focalRatio(e, f, -w) : arcRatio(e, f, w));
  if (zF < 4)
    zF = std::max(zF, areStraight ? focalRatio(f, e, w) : arcRatio(f, e, -w));
  return {arcOrder(zE, alphaE), arcOrder(zF, alphaF)};
}

}  // namespace epafi::bem
