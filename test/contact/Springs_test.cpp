// Free rigid motions on springs.
#include "bem/base/Error.hpp"
#include "contact/RandomProblem.hpp"
#include "contact/Solve.hpp"
#include "reference/Violation.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>

namespace epafi {

namespace {

using contact::Index;
using contact::Matrix;
using contact::Problem;
using contact::Status;
using contact::Vector;

Problem sprung(const char* law, double springs, std::mt19937& random) {
  test::Recipe recipe;
  recipe.normals = 4 + static_cast<Index>(random() % 20);
  recipe.law = law;
  recipe.strength = 0.5;
  recipe.rigidMotions = 1 + static_cast<Index>(random() % 2);
  recipe.springs = springs;
  return test::randomProblem(recipe, random);
}

TEUCHOS_UNIT_TEST(Springs, ofEveryStiffnessAreSolved) {
  std::mt19937 random(5);
  for (const char* law : {"None", "Tresca", "Coulomb"})
    for (int k = 0; k < 200; ++k) {
      const Problem problem = sprung(law, 9, random);
      const auto solution = test::solve(problem);
      TEST_ASSERT(solution.report.status == Status::Converged);
      TEST_COMPARE(reference::violation(problem, solution.state), <, 1e-10);
    }
}

/// A pad on two points, pressed by q and pulled along, both by springs as well:
///   λₙ + λₙ' + K α = q,  μ q at most along.
TEUCHOS_UNIT_TEST(Springs, thatAreSoftWantNoOtherStageThanNewtons) {
  for (const double stiffness : {1.0, 1e-3, 1e-6, 1e-9})
    for (const double gap : {0.0, 3.0})
      for (const double pull : {0.5, 0.9, -0.9}) {
        const double press = 1 + stiffness * (0.5 + gap);  // λₙ = 1/2 each
        Problem problem = test::block(0.6, {press, pull});
        problem.offset = {-gap, -gap, 0, 0};
        problem.rigidStiffness = {stiffness, stiffness};
        const auto solution = test::solve(problem);
        const auto& [multiplier, rigid] = solution.state;
        TEST_ASSERT(solution.report.status == Status::Converged);
        TEST_EQUALITY(solution.report.stages.size(), std::size_t{1});
        TEST_COMPARE(std::abs(multiplier[0] + multiplier[1] - 1), <, 1e-10);
        TEST_COMPARE(std::abs(rigid[0] - 0.5 - gap), <, 1e-10);
        // sticks up to q = (1 + K/2) μ, α = λₜ; then α = (q - μ) / K
        const double stuck = pull / (1 + 0.5 * stiffness) / 2;
        const double shear = std::clamp(stuck, -0.3, 0.3);
        TEST_COMPARE(std::abs(multiplier[2] + multiplier[3] - 2 * shear), <, 1e-10);
        const double slid = shear == stuck ? shear : (pull - 2 * shear) / stiffness;
        TEST_COMPARE(std::abs(rigid[1] - slid), <, 1e-10 * (1 + std::abs(slid)));
      }
}

TEUCHOS_UNIT_TEST(Springs, thatDoNotFitAreRefused) {
  std::mt19937 random(9);
  Problem problem = sprung("None", 2, random);
  problem.rigidStiffness.push_back(1);
  TEST_THROW(problem.check(), bem::InputError);
  problem.rigidStiffness.assign(problem.rigidLoad.size(), -1.0);
  TEST_THROW(problem.check(), bem::NumericalError);
}

}  // namespace

}  // namespace epafi
