#include "bem/base/Error.hpp"
#include "contact/RandomProblem.hpp"
#include "contact/Solve.hpp"
#include "contact/equation/Equilibrium.hpp"
#include "reference/Violation.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace epafi {

namespace {

using contact::Index;
using contact::Problem;
using test::solve;
using test::SolverOptions;

/// A cantilever of length and stiffness one over a plane, under a uniform load that lays
/// its end flat: Euler and Bernoulli's Green's function, a little local flexibility.
/// Multiplier coefficients are point forces.
Problem cantilever(Index n) {
  Problem problem;
  problem.normals = n;
  contact::Matrix flexibility(n, n);
  const auto place = [n](Index i) {
    return static_cast<double>(i + 1) / static_cast<double>(n);
  };
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      const double near = std::min(place(i), place(j));
      const double far = std::max(place(i), place(j));
      flexibility(i, j) = near * near * (3 * far - near) / 6;
    }
    flexibility(i, i) += 1e-7;
    const double x = place(i);
    problem.offset.push_back(x * x * (x * x - 4 * x + 6) / 24 - 1e-3);
  }
  problem.flexibility = std::move(flexibility);
  return problem;
}

TEUCHOS_UNIT_TEST(Fallbacks, aCantileverIsSolvedHoweverFineItsMesh) {
  for (const Index n : {20, 80, 320}) {
    const Problem problem = cantilever(n);
    const auto solution = solve(problem, {}, {});
    TEST_ASSERT(solution.report.status == contact::Status::Converged);
    TEST_COMPARE(reference::violation(problem, solution.state), <, 1e-9);
  }
}

/// Pressed down by N = 2 and sideways by T: balance needs T <= 1.
Problem pushed(double tangentialLoad) { return test::block(0.5, {2, tangentialLoad}); }

TEUCHOS_UNIT_TEST(Fallbacks, globalSlidingIsProvedFromTheFrictionCone) {
  for (const double sign : {-1.0, 1.0}) {
    TEST_NOTHROW(requireEquilibrium(pushed(sign * 0.3)));
    TEST_NOTHROW(requireEquilibrium(pushed(sign * (1 - 1e-7))));
    TEST_NOTHROW(requireEquilibrium(pushed(sign)));
    TEST_THROW(requireEquilibrium(pushed(sign * (1 + 1e-7))), bem::NumericalError);
    TEST_THROW(requireEquilibrium(pushed(sign * 10)), bem::NumericalError);
  }
  Problem lifted = pushed(0);
  lifted.rigidLoad[0] = -2;
  TEST_THROW(requireEquilibrium(lifted), bem::NumericalError);
  // at most 0.3 on each of two sides, whatever the pressure
  for (const auto& [law, fields] : std::vector<std::pair<std::string, bem::Vector>>{
           {"Tresca", {0.3}}, {"Capped Coulomb", {0.5, 0.3}}}) {
    Problem bounded = pushed(0.6);
    for (const Index i : {0, 1})
      bounded.tangentials[bem::at(i)] =
          contact::Tangential(i, test::pointLaw(law, fields));
    TEST_NOTHROW(requireEquilibrium(bounded));
    bounded.rigidLoad[1] = 0.6 * (1 + 1e-7);
    TEST_THROW(requireEquilibrium(bounded), bem::NumericalError);
    bounded.rigidLoad[1] = -0.9;
    const contact::UnresistedMotion motion = unresistedMotion(bounded);
    TEST_FLOATING_EQUALITY(motion.held / motion.load, 0.6 / 0.9, 1e-12);
  }
  Problem unloaded = pushed(0);
  unloaded.rigidLoad = {0, 0};
  TEST_NOTHROW(requireEquilibrium(unloaded));
}

TEUCHOS_UNIT_TEST(Fallbacks, balancedLoadsAreNeverRefused) {
  std::mt19937 random(43);
  for (int k = 0; k < 300; ++k) {
    test::Recipe recipe;
    const char* laws[] = {"None", "Tresca", "Coulomb"};
    recipe.law = laws[k % 3];
    recipe.normals = 2 + k % 30;
    recipe.rigidMotions = 1 + k % 2;
    recipe.ties = k % 4 == 0;
    TEST_NOTHROW(requireEquilibrium(randomProblem(recipe, random)));
  }
}

TEUCHOS_UNIT_TEST(Fallbacks, stagesAccountForEveryStep) {
  std::mt19937 random(53);
  for (int k = 0; k < 300; ++k) {
    test::Recipe recipe;
    const char* laws[] = {"None", "Tresca", "Coulomb"};
    recipe.law = laws[k % 3];
    recipe.normals = 4 + k % 30;
    recipe.strength = 10;
    SolverOptions options;
    options.coulomb.iteration = k % 2 == 0 ? "Newton" : "Fixed Point";
    const auto report = solve(randomProblem(recipe, random), {}, options).report;
    int steps = 0;
    for (const contact::StageRun& run : report.stages) {
      steps += run.steps;
      int parts = 0;
      for (const contact::StageRun& part : run.parts)
        parts += part.steps;
      TEST_ASSERT(run.parts.empty() || parts == run.steps);
    }
    TEST_EQUALITY(steps, report.newtonIterations);
    TEST_EQUALITY(report.status == contact::Status::Converged,
                  report.stages.back().end == contact::End::Converged);
  }
}

/// D = 2, known without its entries.
class Springs final : public contact::Flexibility::Operator {
 public:
  explicit Springs(Index size) : size_(size) {}
  Index size() const override { return size_; }
  Product product(const contact::Vector& x) const override {
    return {times(x), times(x)};
  }
  contact::Vector times(const contact::Vector& x) const override {
    contact::Vector y = x;
    for (double& value : y)
      value *= 2;
    return y;
  }
  contact::Matrix formed() const override { return test::identity(size_, 2); }
  std::unique_ptr<Factor> factor(System system) const override {
    return std::make_unique<Solved>(std::move(system));
  }

 private:
  struct Solved final : Factor {
    explicit Solved(System system) : system_(std::move(system)) {}
    contact::Matrix solve(contact::Matrix b) const override {
      for (const Index i : system_.rows)
        b(i, 0) /= 2;
      return b;
    }
    System system_;
  };

  Index size_;
};

TEUCHOS_UNIT_TEST(Fallbacks, aProblemTooLargeToPivotSaysThatThisWasNotTried) {
  Problem problem;
  problem.normals = contact::ContactSolver::mostToPivot + 1;
  problem.flexibility = contact::Flexibility(std::make_shared<Springs>(problem.normals));
  for (Index i = 0; i < problem.normals; ++i)
    problem.offset.push_back(i % 2 == 0 ? 1 : -1);
  SolverOptions options;
  options.contact.maximumIterations = 1;
  const auto halfSteps = std::make_shared<Teuchos::ParameterList>("NOX");
  halfSteps->sublist("Line Search").sublist("Full Step").set("Full Step", 0.5);
  options.nox = halfSteps;
  const auto report = solve(problem, {}, options).report;
  TEST_ASSERT(report.status == contact::Status::NotConverged);
  TEST_EQUALITY(report.stages.size(), 2u);
  TEST_ASSERT(report.stages.front().end == contact::End::Iterations);
  TEST_ASSERT(report.stages.back().stage == contact::Stage::FollowOffset);
  TEST_ASSERT(report.stages.back().end == contact::End::TooLarge);
}

TEUCHOS_UNIT_TEST(Fallbacks, pivotingIsGivenUpAfterSoMuchWork) {
  const Problem problem = cantilever(80);
  SolverOptions options;
  options.contact.maximumIterations = 3;
  const auto solved = solve(problem, {}, options).report;
  TEST_ASSERT(solved.converged());
  TEST_ASSERT(solved.stages.back().stage == contact::Stage::FollowOffset);
  options.contact.mostWork = 5.5 * contact::workOfPivot(problem.size());
  const auto report = solve(problem, {}, options).report;
  TEST_ASSERT(!report.converged());
  TEST_EQUALITY(report.stages.size(), 3u);
  TEST_ASSERT(report.stages[1].stage == contact::Stage::FollowOffset);
  TEST_ASSERT(report.stages[2].stage == contact::Stage::FollowOffset);
  TEST_ASSERT(report.stages[2].end == contact::End::TooLong);
}

}  // namespace

}  // namespace epafi
