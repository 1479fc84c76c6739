#include "contact/RandomProblem.hpp"
#include "contact/solve/Advance.hpp"
#include "contact/solve/Course.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <limits>
#include <vector>

namespace epafi {

namespace {

using contact::advance;
using contact::Course;
using contact::End;
using contact::Problem;
using contact::Solution;
using contact::Stage;
using contact::State;
using contact::Status;

constexpr int unlimited = std::numeric_limits<int>::max();

Problem someProblem() {
  Problem problem;
  problem.normals = 1;
  problem.flexibility = test::identity(1);
  problem.offset = {1};
  problem.rigid = contact::Matrix(1, 0);
  return problem;
}

/// A solve of one linear system that ends as told.
Solution ended(Status status) {
  Solution solution;
  solution.report.status = status;
  solution.report.newtonIterations = 1;
  return solution;
}

TEUCHOS_UNIT_TEST(Advance, stepsGrowAfterSuccess) {
  std::vector<double> factors;
  const auto path =
      advance({}, {0.25, 1, 0.01}, unlimited, [&](double factor, const State&) {
        factors.push_back(factor);
        return ended(Status::Converged);
      });
  TEST_ASSERT((factors == std::vector<double>{0.25, 0.625, 1}));
  TEST_EQUALITY(path.reached, 1);
  TEST_ASSERT(path.solution.report.converged());
  TEST_EQUALITY(path.solution.report.newtonIterations, 3);
}

/// Nothing beyond 0.6 has a solution: the path comes as near as its smallest step.
TEUCHOS_UNIT_TEST(Advance, stepsShrinkAfterFailureAndTheLastSolutionStays) {
  constexpr double end = 0.6;
  constexpr double smallest = 1.0 / 64;
  const auto path =
      advance({}, {0.25, 1, smallest}, unlimited, [&](double factor, const State&) {
        Solution trial = ended(factor <= end ? Status::Converged : Status::NotConverged);
        trial.state.multiplier = {factor};
        return trial;
      });
  TEST_ASSERT(!path.solution.report.converged());
  TEST_COMPARE(path.reached, <=, end);
  TEST_COMPARE(path.reached, >, end - 2 * smallest);
  TEST_EQUALITY(path.solution.state.multiplier[0], path.reached);
}

TEUCHOS_UNIT_TEST(Advance, endsWhereItsStepsAreSpent) {
  const auto path = advance({}, {0.5, 1, 1e-9}, 7, [](double, const State&) {
    return ended(Status::NotConverged);
  });
  TEST_EQUALITY(path.reached, 0);
  TEST_EQUALITY(path.solution.report.newtonIterations, 7);
}

/// Takes as many steps as the course allows and does not converge, or converges at once.
void fails(Course& course, Stage stage) {
  contact::NewtonRun run;
  run.iterations = course.run();
  run.last = run.best = course.best();
  course.add(stage, run);
}

void succeeds(Course& course, Stage stage) {
  contact::NewtonRun run;
  run.end = End::Converged;
  run.last = run.best = {2};
  course.add(stage, run);
}

bool always(const Course&) { return true; }
bool never(const Course&) { return false; }

constexpr contact::PlannedStage<Course> helped[] = {
    {Stage::FullSteps, always, fails},
    {Stage::Pivoting, never, fails},
    {Stage::FollowOffset, always, succeeds},
    {Stage::FixedPoint, always, fails},
};

TEUCHOS_UNIT_TEST(Plan, stagesThatApplyRunInOrderUntilOneConverges) {
  const Problem problem = someProblem();
  const Solution solution = follow(helped, Course(problem, {}, 5));
  const auto& stages = solution.report.stages;
  TEST_EQUALITY(stages.size(), 2u);
  TEST_ASSERT(stages[0].stage == Stage::FullSteps && stages[0].end == End::Iterations);
  TEST_ASSERT(stages[1].stage == Stage::FollowOffset);
  TEST_ASSERT(solution.report.converged());
  TEST_EQUALITY(solution.report.newtonIterations, 5);
  TEST_EQUALITY(solution.state.multiplier[0], 2);
}

void failsOften(Course& course, Stage stage) {
  for (int k = 0; k < Course::runs + 5; ++k)
    fails(course, stage);
}

constexpr contact::PlannedStage<Course> hopeless[] = {
    {Stage::FullSteps, always, failsOften},
    {Stage::Pivoting, always, succeeds},
};

TEUCHOS_UNIT_TEST(Plan, noStageBeginsWhenTheBudgetIsSpent) {
  const Problem problem = someProblem();
  const Solution solution = follow(hopeless, Course(problem, {}, 3));
  TEST_EQUALITY(solution.report.newtonIterations, 3 * Course::runs);
  TEST_ASSERT(solution.report.stages.back().stage == Stage::FullSteps);
  TEST_ASSERT(!solution.report.converged());
}

}  // namespace

}  // namespace epafi
