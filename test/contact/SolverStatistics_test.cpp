// A thousand random problems of each kind; prints median and worst numbers of Newton
// steps.
#include "contact/RandomProblem.hpp"
#include "contact/Solve.hpp"
#include "reference/Violation.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cctype>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace epafi {

namespace {

using contact::Status;
using test::solve;

struct Statistics {
  std::vector<int> steps;
  int unsolved = 0;
  double violation = 0;
  std::map<std::string, int> paths;  ///< what was tried, and how often
};

/// The stages of a solve without their parts and numbers of steps.
std::string path(std::vector<contact::StageRun> stages) {
  for (contact::StageRun& stage : stages)
    stage.parts.clear();
  std::string text = contact::told(stages);
  text.erase(std::remove_if(text.begin(), text.end(),
                            [](unsigned char c) { return std::isdigit(c) != 0; }),
             text.end());
  return text;
}

Statistics statistics(std::ostream& out, test::Recipe recipe) {
  std::mt19937 random(31);
  Statistics result;
  for (int k = 0; k < 1000; ++k) {
    recipe.normals = 4 + static_cast<contact::Index>(random() % 40);
    recipe.ties = k % 4 == 0;
    recipe.grading = k % 3 == 0 ? 1e3 : 1;
    const auto problem = randomProblem(recipe, random);
    const auto solution = solve(problem);
    result.steps.push_back(solution.report.newtonIterations);
    result.paths[path(solution.report.stages)] += 1;
    if (solution.report.status != Status::Converged) {
      result.unsolved += 1;
      out << "  problem " << k << ": " << told(solution.report.stages) << "\n";
    } else {
      result.violation =
          std::max(result.violation, reference::violation(problem, solution.state));
    }
  }
  std::sort(result.steps.begin(), result.steps.end());
  return result;
}

void print(std::ostream& out, const char* what, const Statistics& s) {
  out << what << ": steps median " << s.steps[s.steps.size() / 2] << ", 99 % "
      << s.steps[s.steps.size() * 99 / 100] << ", worst " << s.steps.back()
      << "; unsolved " << s.unsolved << ", violation " << s.violation << "\n";
  for (const auto& [stages, count] : s.paths)
    out << "  " << count << "  " << stages << "\n";
}

TEUCHOS_UNIT_TEST(SolverStatistics, everyProblemWithFixedBoundsIsSolved) {
  for (const char* law : {"None", "Tresca"})
    for (const contact::Index rigidMotions : {0, 1, 2}) {
      const Statistics s = statistics(out, test::Recipe::of(law, 1, rigidMotions));
      print(out, law, s);
      TEST_EQUALITY(s.unsolved, 0);
      TEST_COMPARE(s.violation, <, 1e-10);
    }
}

TEUCHOS_UNIT_TEST(SolverStatistics,
                  coulombIsSolvedForSmallFrictionAndNearlyAlwaysForLarge) {
  for (const double strength : {0.3, 1.0, 3.0, 10.0}) {
    test::Recipe recipe = test::Recipe::of("Coulomb", strength);
    const Statistics s = statistics(out, recipe);
    out << "f up to " << strength << ": ";
    print(out, recipe.law, s);
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
        print(out, law, s);
        TEST_EQUALITY(s.unsolved, 0);
        TEST_COMPARE(s.violation, <, 1e-10);
      }
}

}  // namespace

}  // namespace epafi
