// The direction in which two sides meet.
#include "contact/opposite/Direction.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>
#include <limits>
#include <random>

namespace epafi {

namespace {

using bem::Continuations;
using bem::Curve;
using bem::Vec2;
using contact::Direction;
using contact::directionBetween;
using contact::SideShape;

constexpr double corner = std::numeric_limits<double>::infinity();

Vec2 along(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// A side of a curvature whose normal has this angle, on a line or circle that goes on for a length
/// on both sides.
SideShape side(double angle, double curvature, double length = 10) {
  return {along(angle), curvature, {{length, 0}, {length, 0}}};
}

SideShape turned(SideShape shape, double angle) {
  shape.normal =
      std::cos(angle) * shape.normal + std::sin(angle) * turnLeft(shape.normal);
  return shape;
}

/// The smallest gap of a roller of radius 1 in what has the curvature κ beside it, slid by a length,
/// linearised, less the gap before.
double gapSlid(double curvature, double slid) {
  double smallest = corner;
  for (double angle = -0.2; angle <= 0.2; angle += 1e-5) {
    const Vec2 x = along(angle - std::acos(-1.0) / 2);
    // where the normal of the roller meets the circle through (0, -1)
    const Vec2 centre{0, -1 - 1 / curvature};
    const double n = dot(x, x - centre);
    const double square = dot(x - centre, x - centre) - 1 / (curvature * curvature);
    const double s = square / (-n + std::copysign(std::sqrt(n * n - square), curvature));
    const Vec2 y = x + s * x;
    const SideShape own{x, 1, {{3, 0}, {3, 0}}};
    const SideShape opposite{curvature * (y - centre), curvature, {{3, 0}, {3, 0}}};
    const Vec2 d = directionBetween(own, opposite).unit;
    smallest = std::min(smallest, dot(y - x, d) - slid * d.x);
  }
  return smallest;
}

}  // namespace

// Exchanged, the sides have the opposite direction and exchange what turns; what is turned as a whole
// has the direction turned.
TEUCHOS_UNIT_TEST(Direction, IsTheSameWhicheverSideIsFirst) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int k = 0; k < 200; ++k) {
    SideShape a = side(any(random), k % 3 == 0 ? 0 : any(random));
    SideShape b = side(std::acos(-1.0) + any(random) / 2, k % 2 == 0 ? 0 : 0.6);
    if (k % 5 == 0)
      a.beyond = {{0.1, corner}, {0.2, 3}};
    if (k % 7 == 0)
      b.beyond = {{0.7, corner}, {0.03, corner}};
    const Direction d = directionBetween(a, b);
    const Direction back = directionBetween(b, a);
    const Direction turnedToo = directionBetween(turned(a, 2), turned(b, 2));
    const bool bothEndless =
        a.curvature == 0 && b.curvature == 0 && k % 5 != 0 && k % 7 != 0;
    TEST_FLOATING_EQUALITY(norm(d.unit), 1.0, 1e-14);
    TEST_COMPARE(norm(d.unit + back.unit), <, bothEndless ? 2.0 : 1e-14);
    TEST_COMPARE(std::abs(d.ownTurn + back.oppositeTurn), <, 1e-12);
    TEST_COMPARE(std::abs(d.oppositeTurn + back.ownTurn), <, 1e-12);
    TEST_FLOATING_EQUALITY(dot(d.unit, a.normal),
                           dot(turnedToo.unit, turned(a, 2).normal), 1e-12);
  }
}

// Beside what is flat it is that normal; of two circles it is the line of their centres, which is
// what counts where the gap is small.
TEUCHOS_UNIT_TEST(Direction, IsTheNormalOfWhatIsFlatAndTheLineOfCentres) {
  const SideShape flat = side(std::acos(-1.0), 0);
  TEST_COMPARE(norm(directionBetween(side(0.3, 2), flat).unit + flat.normal), <, 1e-15);
  TEST_COMPARE(norm(directionBetween(side(0.3, -2), flat).unit + flat.normal), <, 1e-15);
  const double angle = 0.3;
  const double radius = 0.7;  // beside the unit circle about 0
  const Vec2 centre{1.71, 0};
  const Vec2 x = along(angle);
  const double b = dot(x, centre);
  const Vec2 y = (b - std::sqrt(b * b - dot(centre, centre) + radius * radius)) * x;
  const Direction d =
      directionBetween({x, 1, {{3, 0}, {3, 0}}},
                       {(1 / radius) * (y - centre), 1 / radius, {{3, 0}, {3, 0}}});
  TEST_COMPARE(std::abs(cross(d.unit, centre - (y - x))), <, 1e-14);
  TEST_FLOATING_EQUALITY(d.ownTurn, dot(turnLeft(x), d.unit), 1e-14);
  TEST_FLOATING_EQUALITY(d.oppositeTurn, dot(turnLeft(y - centre), d.unit), 1e-13);
}

// A roller that slides across the bottom of a race comes into it by δ²/(2 (R - r)), and so it does in
// the linear gap; one that slides over a cylinder moves away by δ²/(2 (R + r)), which the linear gap
// leaves out.
TEUCHOS_UNIT_TEST(Direction, TellsHowFarSlidingSidesOverlap) {
  for (const double radius : {1.2, 2.0, 6.0, 100.0}) {
    constexpr double slid = 0.01;
    TEST_FLOATING_EQUALITY(gapSlid(-1 / radius, slid), -slid * slid / (2 * (radius - 1)),
                           2e-3);
    TEST_COMPARE(std::abs(gapSlid(1 / radius, slid)), <, 1e-6 * slid);
    const SideShape roller = side(0, 1);
    const SideShape cylinder = side(std::acos(-1.0), 1 / radius);
    TEST_FLOATING_EQUALITY(directionBetween(roller, cylinder).parting, 1 / (radius + 1),
                           1e-14);
  }
}

// A short arc that turns about its own centre leaves its place.
TEUCHOS_UNIT_TEST(Direction, DropsTurnsOfLongArcsOnly) {
  const SideShape flat = side(std::acos(-1.0), 0);
  const SideShape arc{along(0.1), 2, {{0.3, 0}, {0.3, 0}}};
  const SideShape crown{along(0.1), 2, {{0.2, 0}, {0.2, 0}}};
  TEST_FLOATING_EQUALITY(directionBetween(arc, flat).ownTurn, -std::sin(0.1) / 2, 1e-13);
  TEST_EQUALITY_CONST(directionBetween(crown, flat).ownTurn, 0);
  TEST_EQUALITY_CONST(directionBetween(arc, flat).oppositeTurn, 0);
}

// Beside a corner of one side the other one's normal counts; between two corners both do, by the ways
// to them, and a corner far away from what is round does nothing.
TEUCHOS_UNIT_TEST(Direction, IsTheOtherSidesNormalBesideACorner) {
  SideShape flank = side(-0.7, 0);
  flank.beyond.after = {0.2, corner};
  SideShape flat = side(std::acos(-1.0), 0);
  TEST_COMPARE(norm(directionBetween(flank, flat).unit + flat.normal), <, 1e-15);
  TEST_COMPARE(norm(directionBetween(flat, flank).unit - flat.normal), <, 1e-15);
  flat.beyond.before = {0.6, corner};
  const Vec2 between = 0.2 * flank.normal - 0.6 * flat.normal;
  TEST_COMPARE(norm(directionBetween(flank, flat).unit - (1 / norm(between)) * between),
               <, 1e-14);
  const SideShape disc = side(std::acos(-1.0), 0.5);
  TEST_COMPARE(norm(directionBetween(flank, disc).unit + disc.normal), <, 0.3);
  flank.beyond.after.length = 1e-9;
  TEST_COMPARE(norm(directionBetween(flank, disc).unit + disc.normal), <, 1e-8);
  flank.beyond.after.length = 5;
  TEST_COMPARE(norm(directionBetween(flank, disc).unit - flank.normal), <, 1e-15);
}

// A line goes on across vertices that lie on it, up to a corner or to where it is rounded.
TEUCHOS_UNIT_TEST(Direction, KnowsHowTheBoundaryGoesOn) {
  const bem::Outline pad(bem::Loop{{{0, 0}, {2, 0}, {3, 0}, {4, 1}, {4, 3}, {0, 3}},
                                   {"a", "b", "c", "d", "e", "f"},
                                   {0, 0, std::tan(std::acos(-1.0) / 8), 0, 0, 0}});
  const double unit = pad.scaling().length;
  const std::vector<Continuations> all = continuations(pad);
  TEST_EQUALITY_CONST(all[0].before.length, 0);
  TEST_EQUALITY_CONST(all[0].before.curvature, corner);
  TEST_FLOATING_EQUALITY(all[0].after.length, 1 / unit, 1e-14);
  TEST_FLOATING_EQUALITY(all[0].after.curvature, unit, 1e-14);
  TEST_FLOATING_EQUALITY(all[1].before.length, 2 / unit, 1e-14);
  TEST_EQUALITY_CONST(all[1].before.curvature, corner);
  TEST_EQUALITY_CONST(all[2].after.curvature, 0);
  TEST_EQUALITY_CONST(all[3].after.curvature, corner);
  const bem::Curve& right = pad.edge(1).curve;
  const SideShape shape = contact::shapeAt(right, right.normal(0.5), all[1], 0.5);
  TEST_FLOATING_EQUALITY(shape.beyond.before.length, 2.75 / unit, 1e-14);
  TEST_FLOATING_EQUALITY(shape.beyond.after.length, 0.25 / unit, 1e-14);
}

// At an axis of revolution or a line of symmetry it goes on as its image: a plane up to its corner
// beyond, a cone not at all.
TEUCHOS_UNIT_TEST(Direction, KnowsImagesOfTheBoundary) {
  const bem::Loop loop{{{0, 0}, {2, 0}, {2, 1}, {0, 3}}, {"a", "b", "c", "line"}};
  bem::Scaling revolved = bem::scalingOf(loop, true);
  bem::Scaling mirrored = bem::scalingOf(loop);
  mirrored.mirror = "line";
  for (const bem::Scaling& scaling : {revolved, mirrored}) {
    const std::vector<Continuations> all = bem::continuations({loop, {}, scaling});
    TEST_FLOATING_EQUALITY(all[0].before.length, 2 / scaling.length, 1e-14);
    TEST_EQUALITY_CONST(all[0].before.curvature, corner);
    TEST_EQUALITY_CONST(all[2].after.length, 0);
    TEST_EQUALITY_CONST(all[2].after.curvature, corner);
  }
  TEST_EQUALITY_CONST(bem::continuations(bem::Outline(loop))[0].before.length, 0);
}

}  // namespace epafi
