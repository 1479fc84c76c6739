#include "Largest.hpp"
#include "contact/RandomProblem.hpp"
#include "contact/Solve.hpp"
#include "contact/equation/Equation.hpp"
#include "reference/Violation.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace epafi {

namespace {

using contact::Equation;
using contact::Index;
using contact::Problem;
using contact::Solution;
using contact::Status;
using contact::Vector;
using test::largestDifference;
using test::Recipe;
using test::solve;
using test::SolverOptions;

// Recipes of every kind, one per number.
Recipe recipeOf(int k, std::mt19937& random) {
  Recipe recipe = Recipe::of(k % 2 == 0 ? "None" : "Tresca", 1, (k / 2) % 3);
  recipe.normals = 4 + static_cast<Index>(random() % 22);
  const double softness[] = {1, 1e-2, 1e-10};
  recipe.softness = softness[(k / 6) % 3];
  recipe.ties = k % 5 == 0;
  recipe.grading = k % 4 == 0 ? 1e4 : 1;
  return recipe;
}

TEUCHOS_UNIT_TEST(Solver, solvesWithSpringsOfEveryStiffness) {
  std::mt19937 random(5);
  for (const char* law : {"None", "Tresca", "Coulomb"})
    for (int k = 0; k < 200; ++k) {
      Recipe recipe = Recipe::of(law, 0.5, 1 + k % 2);
      recipe.normals = 4 + static_cast<Index>(random() % 20);
      recipe.springs = 9;
      const Problem problem = randomProblem(recipe, random);
      const Solution solution = solve(problem);
      TEST_ASSERT(solution.report.status == Status::Converged);
      TEST_COMPARE(reference::violation(problem, solution.state), <, 1e-10);
    }
}

/// Complementarity, friction and balance, computed from D, d₀, G, q alone.
TEUCHOS_UNIT_TEST(Solver, findsTheContactStateOfRandomFixedBoundProblems) {
  std::mt19937 random(11);
  for (int k = 0; k < 240; ++k) {
    const Problem problem = randomProblem(recipeOf(k, random), random);
    const Solution solution = solve(problem);
    TEST_ASSERT(solution.report.status == Status::Converged);
    TEST_COMPARE(solution.report.residual, <=, solution.report.tolerance);
    TEST_COMPARE(reference::violation(problem, solution.state), <=,
                 4 * solution.report.tolerance);
    contact::State other = solution.state;
    other.multiplier[0] += 0.1;
    TEST_COMPARE(reference::violation(problem, other), >, 1e-7);
  }
}

TEUCHOS_UNIT_TEST(Solver, coulombsThreeIterationsAgree) {
  std::mt19937 random(13);
  for (int k = 0; k < 120; ++k) {
    Recipe recipe = Recipe::of("Coulomb", 0.3, k % 3 == 0 ? 1 : 0);
    recipe.softness = k % 2 == 0 ? 1 : 0.1;
    recipe.normals = 4 + k % 20;
    const Problem problem = randomProblem(recipe, random);
    SolverOptions options;
    const Solution newton = solve(problem, {}, options);
    options.coulomb.iteration = "Inexact Fixed Point";
    const Solution inexact = solve(problem, {}, options);
    options.coulomb.iteration = "Fixed Point";
    const Solution fixedPoint = solve(problem, {}, options);
    for (const Solution* solution : {&newton, &inexact, &fixedPoint}) {
      TEST_ASSERT(solution->report.status == Status::Converged);
      TEST_COMPARE(solution->report.coulombIterations, >, 0);
      TEST_COMPARE(largestDifference(solution->state.multiplier, newton.state.multiplier),
                   <, 1e-8);
      TEST_COMPARE(reference::violation(problem, solution->state), <, 1e-9);
    }
  }
}

TEUCHOS_UNIT_TEST(Solver, holdsBondedPlacesWhateverTheirForce) {
  std::mt19937 random(29);
  int pulling = 0;
  for (int k = 0; k < 120; ++k) {
    Recipe recipe = Recipe::of(k % 2 == 0 ? "Tresca" : "Coulomb", 0.3, k % 3);
    recipe.bonded = true;
    recipe.softness = k % 4 < 2 ? 1 : 0.01;
    recipe.normals = 4 + k % 20;
    const Problem problem = randomProblem(recipe, random);
    for (const char* iteration : {"Newton", "Inexact Fixed Point", "Fixed Point"}) {
      SolverOptions options;
      options.coulomb.iteration = iteration;
      const Solution solution = solve(problem, {}, options);
      TEST_ASSERT(solution.report.status == Status::Converged);
      TEST_COMPARE(reference::violation(problem, solution.state), <, 1e-9);
      const Vector slip = test::slip(problem, solution.state);
      for (std::size_t t = 0; t < slip.size(); t += 3) {
        const Index i = problem.normals + static_cast<Index>(t);
        TEST_COMPARE(std::abs(slip[t]), <, 1e-9 * problem.flexibility(i, i));
        pulling += solution.state.multiplier[i] < -0.1 ? 1 : 0;
      }
    }
  }
  TEST_COMPARE(pulling, >, 250);
}

/// A line search of the user's own lowers Ψ with each step.
TEUCHOS_UNIT_TEST(Solver, theMeritFunctionFallsWithEachStepOfALineSearch) {
  const auto list = std::make_shared<Teuchos::ParameterList>("NOX");
  Teuchos::ParameterList& search = list->sublist("Line Search");
  search.set("Method", "Polynomial").sublist("Polynomial").set("Recovery Step", 0.0);
  const contact::NoxNewton newton(list);
  std::mt19937 random(14);
  int steps = 0;
  for (int k = 0; k < 120; ++k) {
    Recipe recipe = recipeOf(k, random);
    recipe.law = k % 3 == 0 ? "Coulomb" : recipe.law;
    const Problem problem = randomProblem(recipe, random);
    const Equation equation = test::equationOf(problem);
    Vector now(equation.size(), 0.0);
    for (Index i = 0; i < problem.size(); ++i)
      now[i] = std::uniform_real_distribution<double>(-3, 3)(random);
    for (int step = 0; step < 30; ++step) {
      const auto run = newton.run(equation, now, 1);
      TEST_COMPARE(merit(equation, equation.at(run.last)), <=,
                   merit(equation, equation.at(now)) * (1 + 1e-13));
      if (run.end == contact::End::Converged || run.last == now)
        break;
      now = run.last;
      steps += 1;
    }
  }
  out << steps << " steps\n";
  TEST_COMPARE(steps, >, 300);
}

TEUCHOS_UNIT_TEST(Solver, theSolutionNeedsNoStepAndItsNeighboursFew) {
  std::mt19937 random(15);
  for (const char* law : {"None", "Tresca", "Coulomb"})
    for (int k = 0; k < 20; ++k) {
      Problem problem = randomProblem(Recipe::of(law, 0.3, k % 2), random);
      for (const auto coulomb : {"Newton", "Fixed Point"}) {
        SolverOptions options;
        options.coulomb.iteration = coulomb;
        options.coulomb.tolerance = 1e-12;
        const Solution cold = solve(problem, {}, options);
        TEST_EQUALITY(solve(problem, cold.state, options).report.newtonIterations, 0);
      }
      const Solution cold = solve(problem, {}, {});
      for (double& d : problem.offset)
        d *= 1 + 1e-4;
      const Solution warm = solve(problem, cold.state, {});
      TEST_ASSERT(warm.report.status == Status::Converged);
      TEST_COMPARE(warm.report.newtonIterations, <=, 3);
    }
}

TEUCHOS_UNIT_TEST(Solver, classifiesContactAndFriction) {
  Problem problem;
  problem.normals = 3;
  for (Index i = 0; i < 3; ++i)
    problem.tangentials.emplace_back(i, test::pointLaw("Coulomb", {0.5}));
  problem.flexibility = test::identity(6);
  problem.offset = {2, 2, -1, 0.3, -4, 5};
  problem.rigid = contact::Matrix(6, 0);
  const Solution solution = solve(problem, {}, {});
  using contact::ContactState;
  TEST_ASSERT(
      (test::statesOf(problem, solution.state) ==
       contact::ContactStates{ContactState::Closed, ContactState::Closed,
                              ContactState::Open, ContactState::Stick,
                              ContactState::SlipBackward, ContactState::Frictionless}));
  TEST_COMPARE(std::abs(solution.state.multiplier[4] + 1), <, 1e-12);
}

}  // namespace

}  // namespace epafi
