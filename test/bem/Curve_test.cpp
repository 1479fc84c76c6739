// Segments and arcs: places, directions, and how a target is seen from them.
#include "bem/geometry/Curve.hpp"

#include "bem/moments/LegendreLanes.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>
#include <vector>

namespace epafi {

namespace {

using bem::Complex;
using bem::Curve;
using bem::Position;
using bem::Vec2;

const Vec2 from{0.2, -0.3};
const Vec2 to{0.5, 0.1};  // a chord of 1/2

/// Straight, nearly so, to either side, half a circle and more.
std::vector<Curve> samples() {
  std::vector<Curve> curves;
  for (const double bulge : {0.0, 1e-13, 1e-9, -1e-4, 0.05, -0.4, 1.0, -1.7, 4.0})
    curves.emplace_back(from, to, bulge);
  return curves;
}

Position placeOf(const Curve& curve, double t) {
  return {curve.half() * (1 + t), curve.half() * (1 - t)};
}

/// The point `depth` outside the curve at t.
Vec2 beside(const Curve& curve, double t, double depth) {
  return curve.point(t) + depth * curve.normal(t);
}

}  // namespace

TEUCHOS_UNIT_TEST(Curve, segmentsAloneHaveOneFrame) {
  for (const Curve& curve : samples()) {
    if (curve.isStraight()) {
      TEST_NOTHROW(curve.segment());
    } else {
      TEST_THROW(curve.segment(), std::logic_error);
    }
  }
}

TEUCHOS_UNIT_TEST(Curve, goesFromOneEndToTheOtherOnOneCircle) {
  for (const Curve& curve : samples()) {
    TEST_COMPARE(norm(curve.point(-1) - from), <, 1e-15);
    TEST_COMPARE(norm(curve.point(1) - to), <, 1e-15);
    TEST_COMPARE(norm(from + curve.fromStart(curve.length()) - to), <, 4e-15);
    if (std::abs(curve.curvature()) < 1e-2)
      continue;
    const double radius = 1 / curve.curvature();
    const Vec2 centre = from - radius * curve.normal(-1);
    for (const double t : {-0.9, -0.2, 0.0, 0.5, 1.0}) {
      TEST_COMPARE(norm(curve.point(t) - radius * curve.normal(t) - centre), <, 2e-15);
      TEST_COMPARE(std::abs(norm(curve.tangent(t)) - 1), <, 1e-15);
    }
  }
}

TEUCHOS_UNIT_TEST(Curve, bulgesToTheRightByItsTangent) {
  // half a circle over a chord of 1/2: radius 1/4, the middle to the right of the chord
  const Curve semicircle(from, to, 1);
  const double pi = std::acos(-1.0);
  TEST_FLOATING_EQUALITY(semicircle.length(), pi / 4, 1e-15);
  TEST_FLOATING_EQUALITY(semicircle.angle(), pi, 1e-15);
  const Vec2 right = turnRight(2.0 * (to - from));
  TEST_COMPARE(norm(semicircle.point(0) - (0.5 * (from + to) + 0.25 * right)), <, 1e-15);
  TEST_COMPARE(norm(semicircle.tangent(-1) - right), <, 1e-15);
  TEST_COMPARE(norm(semicircle.centroid() - (0.5 * (from + to) + 0.5 / pi * right)), <,
               1e-15);
  const Curve back(to, from, -1);  // the same points, the other way
  TEST_COMPARE(norm(back.point(0.3) - semicircle.point(-0.3)), <, 1e-15);
  TEST_COMPARE(norm(back.normal(0.3) + semicircle.normal(-0.3)), <, 2e-15);
}

TEUCHOS_UNIT_TEST(Curve, movesAtConstantSpeedAlongItsTangent) {
  const double step = 1e-3;
  for (const Curve& curve : samples())
    for (const double t : {-0.7, 0.1, 0.8}) {
      const auto difference = [&](double s) {
        return (1 / (2 * s)) * (curve.point(t + s) - curve.point(t - s));
      };
      const Vec2 slope = (1.0 / 3) * (4 * difference(step) - difference(2 * step));
      TEST_COMPARE(norm(slope - curve.half() * curve.tangent(t)), <, 1e-11);
      TEST_COMPARE(std::abs(dot(curve.normal(t), curve.tangent(t))), <, 1e-15);
      TEST_COMPARE(cross(curve.normal(t), curve.tangent(t)), >, 0);
    }
}

TEUCHOS_UNIT_TEST(Curve, partsLieOnTheWholeAndAddUp) {
  for (const Curve& curve : samples()) {
    const double cuts[] = {-1, -0.31, 0.4, 1};
    double length = 0;
    double angle = 0;
    for (int k = 0; k < 3; ++k) {
      const Curve part = curve.part(placeOf(curve, cuts[k]), placeOf(curve, cuts[k + 1]));
      length += part.length();
      angle += part.angle();
      for (const double s : {-1.0, 0.0, 0.6, 1.0}) {
        const double t = 0.5 * ((1 - s) * cuts[k] + (1 + s) * cuts[k + 1]);
        TEST_COMPARE(norm(part.point(s) - curve.point(t)), <, 2e-15);
        TEST_COMPARE(norm(part.tangent(s) - curve.tangent(t)), <, 2e-15);
        TEST_ASSERT(curve.contains(part.point(s), 1e-14));
      }
    }
    TEST_FLOATING_EQUALITY(length, curve.length(), 1e-15);
    TEST_COMPARE(std::abs(angle - curve.angle()), <, 2e-15);
  }
}

// A short part's ends agree in most digits.
TEUCHOS_UNIT_TEST(Curve, keepsItsDirectionWhereItIsMoved) {
  const Curve whole({0.3, 0.1}, {0.7, -0.2}, 0.1);
  const Vec2 shift{1e-3, -0.4};
  for (const double size : {0.1, 1e-6, 1e-12}) {
    const Curve part = whole.part({0.2, whole.length() - 0.2},
                                  {0.2 + size, whole.length() - 0.2 - size});
    const Curve moved = part.moved(shift);
    for (const double t : {-1.0, 0.3}) {
      TEST_COMPARE(norm(moved.normal(t) - part.normal(t)), <, 1e-15);
      TEST_COMPARE(norm(moved.point(t) - (part.point(t) + shift)), <, 1e-15);
    }
    TEST_FLOATING_EQUALITY(moved.length(), part.length(), 1e-15);
  }
}

TEUCHOS_UNIT_TEST(Curve, knowsItsDistance) {
  for (const Curve& curve : samples()) {
    for (const double depth : {1e-9, 1e-3, -0.02})
      TEST_COMPARE(std::abs(curve.distance(beside(curve, 0.3, depth)) - std::abs(depth)),
                   <, 2e-15);
    const Vec2 ahead = to + 0.01 * curve.tangent(1);
    TEST_COMPARE(std::abs(curve.distance(ahead) - 0.01), <, 1e-15);
    TEST_ASSERT(!curve.contains(beside(curve, -0.5, 1e-9), 1e-10));
  }
}

TEUCHOS_UNIT_TEST(Curve, seesItsOwnPointsAtTheirParameters) {
  for (const Curve& curve : samples())
    for (const double t : {-0.999999, -0.4, 0.0, 0.7, 1 - 1e-9}) {
      // by the chords from both ends, which keep their digits beside an end
      const auto seen = curve.seen(curve.fromStart(curve.half() * (1 + t)),
                                   curve.fromEnd(-curve.half() * (1 - t)));
      TEST_COMPARE(std::abs(seen.z - t), <, 1e-15);
      TEST_COMPARE(std::abs(seen.zMinus1 / (t - 1) - 1.0), <, 2e-15);
      TEST_COMPARE(std::abs(seen.zPlus1 / (t + 1) - 1.0), <, 2e-15);
    }
}

TEUCHOS_UNIT_TEST(Curve, factorsTheOffsetOfATarget) {
  for (const Curve& curve : samples())
    for (const double depth : {-0.2, -1e-3, -1e-8, 1e-8, 0.05})
      for (const double at : {-0.9, 0.2, 0.95}) {
        const Vec2 x = beside(curve, at, depth);
        const auto z = curve.seen(x);
        TEST_COMPARE(depth * z.b(), >, 0);  // the body's side is negative
        for (const double t : {-1.0, -0.6, 0.1, 1.0}) {
          const Complex w = asComplex(x - curve.point(t));
          const Complex product = std::conj(z.z - t) * curve.factor(z, t);
          TEST_COMPARE(std::abs(product - w), <, 1e-14);
        }
      }
}

// 2 Q_j(z) = 2 j!/(2j+1)!! z^-(j+1) (1 + O(z^-2)), whatever else is in the eight.
TEUCHOS_UNIT_TEST(Curve, isSeenFromFarAndNearPlacesTogether) {
  constexpr int top = 26;
  bem::Pack z{};
  for (int lane = 0; lane < bem::lanes; ++lane)
    z[lane] = lane == 0 ? -2.2 : -std::pow(10.0, 2.0 * lane - 2);
  for (const double b : {0.0, 1e-3}) {
    const bem::TargetLanes targets =
        bem::targetAt({z - 1.0, bem::Pack{} + b}, {z + 1.0, bem::Pack{} + b});
    bem::LegendreLanes<2> moments{};
    moments.evaluate(targets, top);
    for (int lane = 3; lane < bem::lanes; ++lane) {
      // of z^-2, and of the logarithms, whose rounding all moments share
      const double error = 1e-5 + 1e-15 * std::abs(z[lane]);
      double leading = 2 / z[lane];
      for (int j = 1; j <= top; ++j) {
        leading *= j / ((2 * j + 1) * z[lane]);
        if (std::abs(leading) > 1e-290)
          TEST_FLOATING_EQUALITY(moments.c[0][j][lane], leading, error);
        TEST_ASSERT(std::isfinite(moments.cubic(targets, j - 1).im[lane]));
      }
    }
  }
}

}  // namespace epafi
