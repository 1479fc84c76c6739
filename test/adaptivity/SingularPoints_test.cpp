// The singular points of several steps on one mesh, and further ones.
#include "adaptivity/singular/SingularPoints.hpp"

#include "Rectangle.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi {

using adaptivity::Singularity;
using adaptivity::SingularPoints;
using adaptivity::united;

namespace {

using Places = std::vector<double>;

/// Of one state on two elements.
SingularPoints points(const Places& first, const Places& second = {},
                      const std::vector<Singularity>& nodes = {Singularity::None,
                                                               Singularity::None}) {
  return {nodes, {first, second}};
}

}  // namespace

/// Straight sides between half circles, and a circle of four parts.
TEUCHOS_UNIT_TEST(SingularPoints, areWhereTheCurvatureOfASideInContactJumps) {
  bem::Loop loop = test::rectangle({-1, -1}, 2, 2);
  loop.edges = {"side", "side", "side", "side"};
  const double quarter = std::tan(std::acos(-1.0) / 8);
  for (const bool isCircle : {false, true}) {
    loop.bulges =
        isCircle ? std::vector<double>(4, quarter) : std::vector<double>{0, 1, 0, 1};
    const bem::Mesh mesh = bem::makeMesh(test::outlineOf(loop), {2, 2, 2, 2}, 1);
    contact::Conditions touches;
    touches.contact["side"] = {[](bem::Vec2) { return 0.0; },
                               contact::makeFriction("None", {})};
    contact::Conditions isSeen;
    for (int edge = 0; edge < 4; ++edge)
      isSeen.facing.push_back({edge, 0, mesh.outline().edge(edge).curve.length()});
    const auto strongWith = [&](const contact::Conditions& conditions) {
      const auto nodes = adaptivity::findSingularPoints(mesh, conditions).nodes;
      return std::count(nodes.begin(), nodes.end(), Singularity::Strong);
    };
    TEST_EQUALITY(strongWith({}), 0);
    TEST_EQUALITY(strongWith(touches), isCircle ? 0 : 4);
    TEST_EQUALITY(strongWith(isSeen), isCircle ? 0 : 4);
  }
}

TEUCHOS_UNIT_TEST(United, ofOneStateAreItsOwnHoweverCloseTheyAre) {
  const SingularPoints one =
      points({-0.01, 0, 0.01}, {0.5}, {Singularity::Weak, Singularity::Strong});
  const SingularPoints result = united({one});
  TEST_ASSERT(result.nodes == one.nodes);
  TEST_ASSERT(result.inside == one.inside);
  TEST_EQUALITY(result.states, 1);
}

TEUCHOS_UNIT_TEST(United, takeTheWorstOfEachNode) {
  const auto none = Singularity::None;
  const auto weak = Singularity::Weak;
  const auto strong = Singularity::Strong;
  TEST_ASSERT(united({points({}, {}, {none, strong}), points({}, {}, {weak, weak}),
                      points({}, {}, {none, none})})
                  .nodes == std::vector<Singularity>({weak, strong}));
}

// A tenth of an element is 0.2 in t.
TEUCHOS_UNIT_TEST(United, takePlacesCloserThanATenthOfAnElementForOne) {
  TEST_ASSERT(united({points({0.1}), points({0.29})}).inside[0] == Places({0.1}));
  TEST_ASSERT(united({points({0.1}), points({0.31})}).inside[0] == Places({0.1, 0.31}));
  TEST_ASSERT(united({points({0.1}), points({-0.11})}).inside[0] == Places({-0.11, 0.1}));
}

TEUCHOS_UNIT_TEST(United, keepElementsApart) {
  const SingularPoints result =
      united({points({0.1}, {-0.5}), points({}, {0.1}), points({0.6}, {})});
  TEST_ASSERT(result.inside == std::vector<Places>({{0.1, 0.6}, {-0.5, 0.1}}));
  TEST_EQUALITY(result.states, 3);
}

TEUCHOS_UNIT_TEST(WithStrong, nextToANodeTheyAreAtTheNode) {
  const bem::Mesh mesh = test::squareMesh(2);
  const double h = 2 * mesh[0].half;
  SingularPoints none;
  none.nodes.resize(mesh.size());
  none.inside.resize(mesh.size());
  const auto placed = [&](const std::vector<double>& fromStart) {
    std::vector<adaptivity::EdgePlace> places;
    for (const double place : fromStart)
      places.push_back({0, place});
    return adaptivity::withStrong(none, mesh, places);
  };
  for (const double offset : {-0.009, 0.0, 0.009}) {
    const auto points = placed({(1 + offset) * h});
    TEST_ASSERT(points.nodes[1] == Singularity::Strong);
    TEST_ASSERT(points.inside[0].empty() && points.inside[1].empty());
  }
  // at both ends of an edge, too, by places that rounding has moved
  for (const int node : {0, 2})
    for (const double offset : {-1e-13, -1e-16, 0.0, 1e-15, 1e-13})
      TEST_ASSERT(placed({node * h + offset}).nodes[node] == Singularity::Strong);
  // and of two that are as close the first one counts
  const auto points = placed({1.25 * h, 1.259 * h});
  TEST_ASSERT(points.nodes[1] == Singularity::None);
  TEST_EQUALITY(points.inside[1].size(), 1u);
  TEST_FLOATING_EQUALITY(points.inside[1].front(), -0.5, 1e-12);
}

}  // namespace epafi
