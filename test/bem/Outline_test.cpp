#include "bem/geometry/Outline.hpp"

#include "Message.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace {

using epafi::bem::InputError;
using epafi::bem::Loop;
using epafi::bem::Outline;
using epafi::bem::Vec2;
using epafi::test::contains;

Loop named(const std::vector<Vec2>& vertices) {
  Loop loop{vertices, {}};
  for (std::size_t i = 0; i < vertices.size(); ++i)
    loop.edges.push_back("e" + std::to_string(i));
  return loop;
}

Loop rectangle(double x0, double y0, double x1, double y1) {
  return named({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

/// Area of the body by Gauss' theorem, in the user's units: 1/2 sum of x·n length.
double area(const Outline& outline) {
  double sum = 0;
  for (const auto& edge : outline.edges())
    sum += 0.5 * dot(edge.curve.from(), edge.curve.normal(0)) * edge.curve.length();
  return sum * outline.diameter() * outline.diameter();
}

std::string complaint(const Loop& outer, const std::vector<Loop>& holes = {}) {
  return epafi::test::messageOf([&] { Outline(outer, holes); });
}

}  // namespace

TEUCHOS_UNIT_TEST(Outline, hasTheAreaOfThePolygonLessItsHoles) {
  const Outline plain(rectangle(1, 2, 4, 6));
  TEST_FLOATING_EQUALITY(area(plain), 12.0, 1e-14);
  const Outline holed(rectangle(1, 2, 4, 6),
                      {rectangle(1.5, 2.5, 2, 3), named({{3, 4}, {3.5, 4}, {3, 5}})});
  TEST_FLOATING_EQUALITY(area(holed), 12.0 - 0.25 - 0.25, 1e-14);
  TEST_EQUALITY(holed.loops(), 3);
}

TEUCHOS_UNIT_TEST(Outline, hasDiameterOneInsideAndGivesTheUsersCoordinatesBack) {
  const Outline outline(rectangle(1000, 2000, 1003, 2004));
  TEST_FLOATING_EQUALITY(outline.diameter(), 5.0, 1e-15);
  for (const auto& edge : outline.edges())
    for (Vec2 p : {edge.curve.from(), edge.curve.to()})
      TEST_FLOATING_EQUALITY(norm(p), 0.5, 1e-14);
  const Vec2 p = outline.physical(outline.scaled({1001, 2003}));
  TEST_FLOATING_EQUALITY(p.x, 1001.0, 1e-15);
  TEST_FLOATING_EQUALITY(p.y, 2003.0, 1e-15);
}

TEUCHOS_UNIT_TEST(Outline, keepsTheBodyOnTheLeftAndTheNormalOutward) {
  const Outline outline(rectangle(0, 0, 4, 4), {rectangle(1, 1, 3, 2)});
  for (const auto& edge : outline.edges()) {
    const Vec2 middle = outline.physical(0.5 * (edge.curve.from() + edge.curve.to()));
    TEST_ASSERT(outline.contains(middle - 1e-3 * edge.curve.normal(0)));
    TEST_ASSERT(!outline.contains(middle + 1e-3 * edge.curve.normal(0)));
    TEST_EQUALITY(outline.edge(edge.next).curve.from().x, edge.curve.to().x);
    TEST_EQUALITY(outline.edge(edge.next).curve.from().y, edge.curve.to().y);
    TEST_EQUALITY(outline.edge(outline.edge(edge.next).previous).boundary, edge.boundary);
  }
}

TEUCHOS_UNIT_TEST(Outline, givesEachEdgeOfAHoleItsOwnNameThoughItRunsBackwards) {
  const Loop hole = named({{1, 1}, {3, 1}, {3, 2}, {1, 2}});
  const Outline outline(rectangle(0, 0, 4, 4), {hole});
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 middle = 0.5 * (hole.vertices[i] + hole.vertices[(i + 1) % 4]);
    for (const auto& edge : outline.edges())
      if (edge.loop == 1 && edge.boundary == hole.edges[i])
        TEST_COMPARE(
            norm(outline.physical(0.5 * (edge.curve.from() + edge.curve.to())) - middle),
            <, 1e-14);
  }
}

TEUCHOS_UNIT_TEST(Outline, containsThePointsInsideButNotThoseOnTheBoundaryOrInHoles) {
  // An L whose reflex corner and horizontal edges lie at the height of tested points.
  const Outline outline(named({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}),
                        {rectangle(0.5, 0.5, 1, 1)});
  for (Vec2 p : {Vec2{1, 2}, Vec2{3, 1}, Vec2{1, 3}, Vec2{0.25, 1}, Vec2{1e-9, 1}})
    TEST_ASSERT(outline.contains(p));
  for (Vec2 p : {Vec2{3, 3}, Vec2{-1, 2}, Vec2{5, 2}, Vec2{3, 2}, Vec2{2, 2}, Vec2{0, 0},
                 Vec2{0.75, 0.75}, Vec2{1, 0.7}, Vec2{2, 5}})
    TEST_ASSERT(!outline.contains(p));
}

TEUCHOS_UNIT_TEST(Outline, refusesAPolygonThatCrossesOrTouchesItself) {
  const std::string bow = complaint(named({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));
  TEST_ASSERT(contains(bow, "touches or crosses itself"));
  TEST_ASSERT(contains(bow, "edge 0 ('e0')") && contains(bow, "edge 2 ('e2')"));
  // A vertex that comes to lie on another edge.
  TEST_ASSERT(contains(complaint(named({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})),
                       "touches or crosses itself"));
  // An edge that runs back along its predecessor.
  TEST_ASSERT(contains(complaint(named({{0, 0}, {4, 0}, {2, 0}, {2, 2}})), "runs back"));
}

TEUCHOS_UNIT_TEST(Outline, refusesClockwiseOpenAndDegeneratePolygons) {
  TEST_ASSERT(contains(complaint(named({{0, 0}, {0, 1}, {1, 1}, {1, 0}})), "clockwise"));
  TEST_ASSERT(contains(
      complaint(rectangle(0, 0, 4, 4), {named({{1, 1}, {1, 2}, {2, 2}, {2, 1}})}),
      "hole 1: the polygon runs clockwise"));
  TEST_ASSERT(contains(complaint(named({{0, 0}, {1, 0}})), "at least 3 vertices"));
  TEST_ASSERT(contains(complaint(named({{0, 0}, {1, 0}, {1, 1}, {0, 0}})),
                       "do not repeat the first vertex"));
  TEST_ASSERT(contains(complaint(named({{0, 0}, {1, 0}, {1, NAN}})), "not finite"));
  TEST_ASSERT(contains(complaint(named({{0, 0}, {1, 0}, {1, 0}, {1, 1}})), "no length"));
  for (const double size : {1e-300, 1e300})
    TEST_ASSERT(contains(complaint(rectangle(0, 0, size, size)), "unit of length"));
  Loop open = rectangle(0, 0, 1, 1);
  open.edges.pop_back();
  TEST_ASSERT(contains(complaint(open), "3 names are given"));
}

TEUCHOS_UNIT_TEST(Outline, refusesHolesThatTouchCrossOrLieOutside) {
  const Loop outer = rectangle(0, 0, 4, 4);
  TEST_ASSERT(contains(complaint(outer, {rectangle(0, 1, 1, 2)}), "touch or cross"));
  TEST_ASSERT(contains(complaint(outer, {rectangle(3, 1, 5, 2)}), "touch or cross"));
  TEST_ASSERT(contains(complaint(outer, {rectangle(5, 1, 6, 2)}), "does not lie inside"));
  TEST_ASSERT(contains(complaint(outer, {rectangle(1, 1, 2, 2), rectangle(2, 2, 3, 3)}),
                       "hole 1 and hole 2 touch or cross"));
  TEST_ASSERT(
      contains(complaint(outer, {rectangle(1, 1, 3, 3), rectangle(1.5, 1.5, 2, 2)}),
               "lie inside each other"));
  TEST_EQUALITY(complaint(outer, {rectangle(1, 1, 2, 2), rectangle(2.1, 2, 3, 3)}), "");
}

TEUCHOS_UNIT_TEST(Outline, acceptsAcuteCornersAndThinBodies) {
  TEST_EQUALITY(complaint(named({{0, 0}, {1, 0}, {1, 0.08}})), "");
  TEST_EQUALITY(complaint(rectangle(0, 0, 1, 1e-6)), "");
  TEST_EQUALITY(complaint(named({{0, 0}, {1, 0}, {2, 0}, {1, 1e-3}})), "");
}

TEUCHOS_UNIT_TEST(Outline, sharesAScalingWithALargerBody) {
  const Loop small = rectangle(1, 2, 4, 6);
  const Outline alone(small);
  const epafi::bem::Scaling shared{{7, -2}, 3 * alone.diameter()};
  const Outline beside(small, {}, shared);
  TEST_EQUALITY(beside.diameter(), alone.diameter());
  TEST_EQUALITY(beside.units(5).length, shared.length);
  for (int e = 0; e < 4; ++e) {
    const auto& curve = beside.edge(e).curve;
    TEST_FLOATING_EQUALITY(3 * curve.length(), alone.edge(e).curve.length(), 1e-15);
    const Vec2 vertex = small.vertices[e];
    TEST_COMPARE(norm(beside.physical(curve.from()) - vertex), <, 4e-15);
  }
  const epafi::bem::Scaling tooSmall{{0, 0}, 0.99 * alone.diameter()};
  TEST_THROW(Outline(small, {}, tooSmall), InputError);
}

namespace {

/// Two vertices, as bulges say.
Loop lens(double first, double second) {
  Loop loop = named({{1, 0}, {-1, 0}});
  loop.bulges = {first, second};
  return loop;
}

Loop withBulges(Loop loop, const std::vector<double>& bulges) {
  loop.bulges = bulges;
  return loop;
}

}  // namespace

TEUCHOS_UNIT_TEST(Outline, isOfArcs) {
  const Outline circle(lens(1, 1));
  TEST_FLOATING_EQUALITY(circle.diameter(), 2.0, 1e-14);
  for (const double x : {-0.999, -0.3, 0.0, 0.7})
    for (const double y : {-0.9, -0.2, 0.0, 0.5, 1.1})
      TEST_EQUALITY(circle.contains({x, y}), std::hypot(x, y) < 1);
  TEST_ASSERT(!circle.contains({1, 0}));
  // a hole runs the other way: its arcs stay where they are drawn
  const Outline ring(lens(1, 1), {withBulges(named({{0.5, 0}, {-0.5, 0}}), {1, 0.2})});
  TEST_ASSERT(!ring.contains({0, 0.4}));
  TEST_ASSERT(ring.contains({0, -0.4}));
  TEST_ASSERT(!ring.contains({0, -0.05}));
  TEST_EQUALITY(complaint(lens(1, -0.9)), "");  // a crescent
}

TEUCHOS_UNIT_TEST(Outline, refusesArcsThatTouchOrCross) {
  const Loop square = rectangle(0, 0, 2, 2);
  const auto sides = [&](const std::vector<double>& bulges) {
    return complaint(withBulges(square, bulges));
  };
  TEST_EQUALITY(sides({0.4, 0.4, 0.4, 0.4}), "");
  TEST_EQUALITY(sides({-0.4, 0.4, -0.4, 0.4}), "");
  // half a circle inwards would run back along the neighbours
  TEST_ASSERT(contains(sides({0, -1, 0, 0}), "edge 0 ('e0') and edge 1 ('e1')"));
  // arcs inwards from both sides of a narrow body touch in the middle, more of them cross
  const auto waist = [](double bulge) {
    return complaint(withBulges(rectangle(0, 0, 1, 2), {0, bulge, 0, bulge}));
  };
  TEST_EQUALITY(waist(-0.49), "");
  TEST_ASSERT(contains(waist(-0.5), "edge 1 ('e1') and edge 3 ('e3')"));
  TEST_ASSERT(contains(waist(-0.6), "edge 1 ('e1') and edge 3 ('e3')"));
  // neighbours that cross again away from their corner
  TEST_ASSERT(contains(sides({-1.2, -1.2, 0, 0}), "edge 0 ('e0') and edge 1 ('e1')"));
  TEST_ASSERT(contains(complaint(lens(0.5, -0.5)), "touches or crosses itself"));
  TEST_ASSERT(contains(complaint(lens(-1, -1)), "clockwise"));
  TEST_ASSERT(contains(
      complaint(square, {withBulges(rectangle(0.5, 0.5, 1.5, 1.5), {1, 0, 0, 0})}),
      "touch or cross"));
}

/// Takes minutes where the diameter is sought for each corner among all pairs of points.
TEUCHOS_UNIT_TEST(Outline, ofManyArcsHasTheirDiameter) {
  constexpr int arcs = 400;
  const double pi = std::acos(-1.0);
  for (const double bulge : {0.3, std::tan(pi / (2 * arcs))}) {  // bulged; one circle
    std::vector<Vec2> vertices;
    for (int k = 0; k < arcs; ++k) {
      const double angle = 2 * pi * k / arcs;
      vertices.push_back({3 + std::cos(angle), std::sin(angle) - 2});
    }
    const Outline outline(withBulges(named(vertices), std::vector<double>(arcs, bulge)));
    // between the middles of opposite arcs
    const double expected = 2 * (std::cos(pi / arcs) + bulge * std::sin(pi / arcs));
    TEST_FLOATING_EQUALITY(outline.diameter(), expected, 1e-14);
  }
}

TEUCHOS_UNIT_TEST(Outline, hasTheLargestDistanceOfItsVerticesForDiameter) {
  for (const std::vector<Vec2>& vertices :
       {std::vector<Vec2>{{0, 0}, {5, 1}, {4, 2}, {2, 7}},
        {{0, 0}, {1, 0}, {1, 0.08}},
        {{0, 0}, {2, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}, {0, 2}},
        {{0.1, 0.1}, {3, -0.7}, {9.3, 0}, {3.3, 1e-6}, {0.2, 0.9}}}) {
    double largest = 0;
    for (const Vec2 a : vertices)
      for (const Vec2 b : vertices)
        largest = std::max(largest, norm(a - b));
    TEST_EQUALITY(Outline(named(vertices)).diameter(), largest);
  }
}

TEUCHOS_UNIT_TEST(Outline, wantsABulgeForEachEdge) {
  TEST_ASSERT(contains(complaint(withBulges(rectangle(0, 0, 1, 1), {0.1})), "as many"));
  TEST_ASSERT(contains(complaint(lens(11, 1)), "from -10 to 10"));
  TEST_ASSERT(contains(complaint(lens(0, 0)), "at least 3"));
}
