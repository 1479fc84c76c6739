#include "contact/newton/OffsetPath.hpp"

#include "contact/RandomProblem.hpp"
#include "contact/Solve.hpp"
#include "reference/Violation.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>
#include <exception>
#include <random>
#include <utility>
#include <vector>

namespace epafi {

namespace {

using contact::followOffset;
using contact::Index;
using contact::OffsetPath;
using contact::Problem;
using contact::State;

State stateOf(const Problem& problem, const OffsetPath& path) {
  return contact::unpack(problem, path.unknowns);
}

OffsetPath pathOf(const Problem& problem) {
  return followOffset(problem, contact::Vector(problem.rigidLoad.size(), 0.0), 0,
                      10 * static_cast<int>(problem.size()));
}

/// Without a start and without one of Newton's steps: all kinds of bounds, coefficients up to 10.
TEUCHOS_UNIT_TEST(OffsetPath, solvesRandomProblems) {
  std::mt19937 random(5);
  for (const char* law : {"None", "Tresca", "Coulomb"})
    for (const bool bonded : {false, true})
      for (int k = 0; k < 120; ++k) {
        test::Recipe recipe = test::Recipe::of(law, 10);
        recipe.normals = 4 + static_cast<Index>(random() % 40);
        recipe.bonded = bonded && law != std::string("None");
        recipe.ties = k % 4 == 0;
        recipe.grading = k % 3 == 0 ? 1e3 : 1;
        const Problem problem = randomProblem(recipe, random);
        const OffsetPath path = pathOf(problem);
        TEST_ASSERT(path.arrived);
        TEST_COMPARE(path.pivots, <=, 3 * problem.size());
        TEST_COMPARE(reference::violation(problem, stateOf(problem, path)), <, 1e-9);
      }
}

/// λₙ pulls its own place open where it slips backwards: D_nn < f D_nt.  Friction followed from zero
/// ends at a fold; with no friction, and with much, there is one solution only.
Problem folded(double coefficient) {
  Problem problem;
  problem.normals = 1;
  problem.tangentials.emplace_back(0, test::pointLaw("Coulomb", {coefficient}));
  contact::Matrix flexibility = test::identity(2);
  flexibility(0, 1) = flexibility(1, 0) = 0.8;
  problem.flexibility = std::move(flexibility);
  problem.rigid = contact::Matrix(2, 0);
  return problem;
}

TEUCHOS_UNIT_TEST(OffsetPath, goesRoundFolds) {
  for (const double coefficient : {0.5, 1.0, 2.0, 5.0, 100.0})
    for (int k = 0; k < 64; ++k) {
      const double angle = std::atan(1) * k / 8;
      Problem problem = folded(coefficient);
      problem.offset = {std::cos(angle), std::sin(angle)};
      const OffsetPath path = pathOf(problem);
      TEST_ASSERT(path.arrived);
      TEST_COMPARE(reference::violation(problem, stateOf(problem, path)), <, 1e-12);
    }
}

/// min(f p, cap): on one side of its kink, on the other, and across.
TEUCHOS_UNIT_TEST(OffsetPath, followsALawOfPieces) {
  std::mt19937 random(7);
  for (const double cap : {0.05, 0.5, 50.0})
    for (int k = 0; k < 40; ++k) {
      test::Recipe recipe;
      recipe.normals = 4 + static_cast<Index>(random() % 20);
      recipe.law = "Coulomb";
      Problem problem = randomProblem(recipe, random);
      for (std::size_t t = 0; t < problem.tangentials.size(); ++t)
        problem.tangentials[t] = {static_cast<Index>(t),
                                  test::pointLaw("Capped Coulomb", {1.5, cap})};
      const OffsetPath path = pathOf(problem);
      TEST_ASSERT(path.arrived);
      TEST_COMPARE(reference::violation(problem, stateOf(problem, path)), <, 1e-9);
    }
}

/// Whoever waits is told, and may end it.
TEUCHOS_UNIT_TEST(OffsetPath, tellsHowFarItIs) {
  struct Enough : std::exception {};
  std::mt19937 random(11);
  const Problem problem = randomProblem(test::Recipe(), random);
  std::vector<std::pair<int, int>> told;
  const contact::Vector none(problem.rigidLoad.size(), 0.0);
  const OffsetPath path = followOffset(problem, none, 0, 1000, [&](int pivots, int most) {
    told.push_back({pivots, most});
  });
  TEST_ASSERT(path.arrived && path.pivots > 0);
  TEST_EQUALITY(told.size(), 1u);  // so little work is done in a moment
  TEST_ASSERT(told.front() == std::make_pair(0, 1000));
  TEST_THROW(followOffset(problem, none, 0, 1000, [](int, int) { throw Enough(); }),
             Enough);
}

/// Springs place a free body to 1e-5 of what the load moves, about, and a second path from there to
/// 1e-10; Newton's steps from there find the last digits.
TEUCHOS_UNIT_TEST(OffsetPath, placesFreeBodies) {
  std::mt19937 random(9);
  for (int k = 0; k < 100; ++k) {
    test::Recipe recipe = test::Recipe::of("Coulomb", 1, 1 + k % 2);
    recipe.normals = 4 + static_cast<Index>(random() % 20);
    const Problem problem = randomProblem(recipe, random);
    const State state = stateOf(problem, pathOf(problem));
    const contact::NoxNewton newton;
    const contact::Equation equation = test::equationOf(problem);
    const contact::NewtonRun run = newton.run(equation, pack(problem, state), 5);
    TEST_ASSERT(run.end == contact::End::Converged);
  }
}

}  // namespace

}  // namespace epafi
