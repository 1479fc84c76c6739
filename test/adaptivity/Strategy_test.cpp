#include "adaptivity/refine/Strategy.hpp"

#include "SquareMesh.hpp"
#include "bem/base/Error.hpp"
#include "bem/basis/Legendre.hpp"

#include <Teuchos_UnitTestHarness.hpp>

namespace epafi {

/// Runs over the table, so a new strategy is tested from the day it is listed.
TEUCHOS_UNIT_TEST(Strategy, everyStrategyMarksEveryElementAndIsFoundByItsName) {
  const bem::Mesh mesh = test::squareMesh(2);
  for (const adaptivity::Strategy& strategy : adaptivity::strategies()) {
    TEST_EQUALITY(adaptivity::strategy(strategy.name).marks, strategy.marks);
    TEST_EQUALITY(static_cast<int>(strategy.marks({mesh}).size()), mesh.size());
  }
}

TEUCHOS_UNIT_TEST(Strategy, uniformStrategiesTreatAllElementsAlike) {
  const bem::Mesh mesh = test::squareMesh(2);
  const bem::Mesh finer =
      adaptivity::refine(mesh, adaptivity::strategy("Uniform h").marks({mesh}));
  const bem::Mesh richer =
      adaptivity::refine(mesh, adaptivity::strategy("Uniform p").marks({mesh}));
  TEST_EQUALITY(finer.size(), 2 * mesh.size());
  TEST_EQUALITY(richer.size(), mesh.size());
  for (int e = 0; e < mesh.size(); ++e) {
    TEST_FLOATING_EQUALITY(finer[2 * e].half, 0.5 * mesh[e].half, 1e-15);
    TEST_FLOATING_EQUALITY(finer[2 * e + 1].half, 0.5 * mesh[e].half, 1e-15);
    TEST_EQUALITY(finer[2 * e].degree, mesh[e].degree);
    TEST_EQUALITY(richer[e].degree, mesh[e].degree + 1);
    TEST_EQUALITY(richer[e].half, mesh[e].half);
  }
}

TEUCHOS_UNIT_TEST(Strategy, uniformPEndsAtTheLargestDegree) {
  const bem::Mesh mesh = test::squareMesh(bem::largestDegree);
  TEST_ASSERT(!adaptivity::anyMarked(adaptivity::strategy("Uniform p").marks({mesh})));
  TEST_ASSERT(!adaptivity::anyMarked(adaptivity::strategy("None").marks({mesh})));
  TEST_ASSERT(adaptivity::anyMarked(adaptivity::strategy("Uniform h").marks({mesh})));
}

TEUCHOS_UNIT_TEST(Strategy, anUnknownNameIsAnInputErrorThatListsTheKnownOnes) {
  try {
    adaptivity::strategy("Uniform q");
    TEST_ASSERT(false);
  } catch (const bem::InputError& error) {
    for (const adaptivity::Strategy& known : adaptivity::strategies())
      TEST_INEQUALITY(std::string(error.what()).find(known.name), std::string::npos);
  }
}

}  // namespace epafi
