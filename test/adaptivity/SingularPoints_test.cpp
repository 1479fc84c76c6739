// The singular points of several steps on one mesh.
#include "adaptivity/singular/SingularPoints.hpp"

#include <Teuchos_UnitTestHarness.hpp>

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

}  // namespace epafi
