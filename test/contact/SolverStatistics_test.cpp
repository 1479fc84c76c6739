// A thousand random problems of each kind.
#include "contact/RandomProblem.hpp"
#include "contact/Solve.hpp"
#include "reference/Violation.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <random>
#include <string>

namespace epafi {

namespace {

using contact::Status;
using test::solve;

struct Statistics {
  int unsolved = 0;
  double violation = 0;
};

Statistics statistics(std::ostream& out, test::Recipe recipe) {
  std::mt19937 random(31);
  Statistics result;
  for (int k = 0; k < 1000; ++k) {
    recipe.normals = 4 + static_cast<contact::Index>(random() % 40);
    recipe.ties = k % 4 == 0;
    recipe.grading = k % 3 == 0 ? 1e3 : 1;
    const auto problem = randomProblem(recipe, random);
    const auto solution = solve(problem);
    if (solution.report.status != Status::Converged) {
      result.unsolved += 1;
      out << recipe.law << ", problem " << k << ": " << told(solution.report.stages)
          << "\n";
    } else {
      result.violation =
          std::max(result.violation, reference::violation(problem, solution.state));
    }
  }
  return result;
}

TEUCHOS_UNIT_TEST(SolverStatistics, everyProblemWithFixedBoundsIsSolved) {
  for (const char* law : {"None", "Tresca"})
    for (const contact::Index rigidMotions : {0, 1, 2}) {
      const Statistics s = statistics(out, test::Recipe::of(law, 1, rigidMotions));
      TEST_EQUALITY(s.unsolved, 0);
      TEST_COMPARE(s.violation, <, 1e-10);
    }
}

TEUCHOS_UNIT_TEST(SolverStatistics,
                  coulombIsSolvedForSmallFrictionAndNearlyAlwaysForLarge) {
  for (const double strength : {0.3, 1.0, 3.0, 10.0}) {
    const Statistics s = statistics(out, test::Recipe::of("Coulomb", strength));
    TEST_COMPARE(s.unsolved, <=, strength <= 3 ? 0 : 5);
    TEST_COMPARE(s.violation, <, 1e-9);
  }
}

TEUCHOS_UNIT_TEST(SolverStatistics, surfacesYieldByAnyLawAndByAnyAmount) {
  for (const char* normal : {"Linear", "Root", "Square", "Exponential"})
    for (const double yield : {1e-3, 1.0, 1e3})
      for (const char* law : {"None", "Tresca", "Coulomb"}) {
        test::Recipe recipe =
            test::Recipe::of(law, 0.3, law == std::string("None") ? 1 : 0);
        recipe.normal = normal;
        recipe.yield = yield;
        const Statistics s = statistics(out, recipe);
        out << normal << ", " << yield << ", ";
        TEST_EQUALITY(s.unsolved, 0);
        TEST_COMPARE(s.violation, <, 1e-10);
      }
}

}  // namespace

}  // namespace epafi
