#include "contact/newton/Pivoting.hpp"

#include "contact/CyclingProblem.hpp"
#include "contact/RandomProblem.hpp"
#include "contact/Solve.hpp"
#include "contact/newton/NewtonStep.hpp"
#include "contact/newton/Sweeps.hpp"
#include "reference/ProjectedSor.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>
#include <random>

namespace epafi {

namespace {

using contact::Equation;
using contact::Evaluation;
using contact::Index;
using contact::Problem;
using contact::Vector;
using test::solve;

Equation equationOf(const Problem& problem) {
  return {problem, contact::projection(), Equation::Bound::Differentiated, 1e-12};
}

/// Copies of the cycling problem for the normal coefficients, random tangential ones, and
/// a little random flexibility that couples them all.
Problem stronglyCoupled(Index copies, const char* law, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Problem block = test::cyclingProblem();
  Problem problem;
  problem.normals = 3 * copies;
  const Index tangentials = law == std::string("None") ? 0 : problem.normals;
  for (Index t = 0; t < tangentials; ++t)
    problem.tangentials.emplace_back(t, contact::pointLaw(law, {0.2}));
  const Index size = problem.size();
  contact::Matrix root(size, size);
  for (Index j = 0; j < size; ++j)
    for (Index i = 0; i < size; ++i)
      root(i, j) = normal(random);
  contact::Matrix flexibility(size, size);
  for (Index i = 0; i < size; ++i) {
    const bool tangential = i >= problem.normals;
    for (Index j = 0; j < size; ++j) {
      for (Index k = 0; k < size; ++k)
        flexibility(i, j) += 0.01 / static_cast<double>(size) * root(i, k) * root(j, k);
      if (!tangential && i / 3 == j / 3)
        flexibility(i, j) += block.flexibility(i % 3, j % 3);
    }
    flexibility(i, i) += tangential ? 5 : 0;
    problem.offset.push_back(tangential ? normal(random) : block.offset[i % 3]);
  }
  problem.flexibility = std::move(flexibility);
  problem.rigid = contact::Matrix(size, 0);
  return problem;
}

Vector afterStep(const Equation& equation, const Evaluation& e,
                 const contact::LinearRows& rows) {
  Vector x = e.unknowns;
  const Vector d = newtonStep(equation, e, rows);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] += d[i];
  return x;
}

/// Steps until converged, or `limit`.
template <class Choice>
int steps(const Equation& equation, Vector x, int limit, const Choice& choose) {
  for (int step = 0; step < limit; ++step) {
    const Evaluation e = equation.at(std::move(x));
    if (e.converged)
      return step;
    x = afterStep(equation, e, holding(equation, e, choose(e)));
  }
  return limit;
}

int stepsOfPivoting(const Equation& equation, const Vector& start, int limit) {
  contact::Pivoting pivoting;
  return steps(equation, start, limit,
               [&](const Evaluation& e) { return pivoting.next(equation, e); });
}

int stepsOfNewton(const Equation& equation, const Vector& start, int limit) {
  return steps(equation, start, limit, contact::rowSet);
}

TEUCHOS_UNIT_TEST(ActiveSets, theClassicalCycleEndsInFewSteps) {
  const Problem problem = test::cyclingProblem();
  const Equation equation = equationOf(problem);
  TEST_EQUALITY(stepsOfNewton(equation, {0, 0, 0}, 100), 100);
  TEST_COMPARE(stepsOfPivoting(equation, {0, 0, 0}, 100), <=, 6);
}

// A tolerance below rounding asks for steps after the set is right.
TEUCHOS_UNIT_TEST(ActiveSets, pivotingKeepsASetThatIsRight) {
  const Problem problem = test::cyclingProblem();
  const Equation equation = equationOf(problem);
  contact::Pivoting pivoting;
  Vector x = {0, 0, 0};
  for (int step = 0; step < 10; ++step) {
    const Evaluation e = equation.at(std::move(x));
    x = afterStep(equation, e, holding(equation, e, pivoting.next(equation, e)));
  }
  const Evaluation last = equation.at(x);
  TEST_ASSERT(last.converged);
  TEST_ASSERT(pivoting.next(equation, last) == contact::rowSet(last));
}

TEUCHOS_UNIT_TEST(ActiveSets, holdingTheOwnSetChangesNothing) {
  std::mt19937 random(61);
  for (int k = 0; k < 60; ++k) {
    test::Recipe recipe;
    const char* laws[] = {"None", "Tresca", "Coulomb"};
    recipe.law = laws[k % 3];
    const Problem problem = randomProblem(recipe, random);
    const Equation equation = equationOf(problem);
    Vector x(equation.size());
    for (double& value : x)
      value = std::uniform_real_distribution<double>(-1, 1)(random);
    const Evaluation e = equation.at(x);
    const contact::LinearRows held = holding(equation, e, rowSet(e));
    for (std::size_t i = 0; i < held.residual.size(); ++i)
      TEST_FLOATING_EQUALITY(held.residual[i], e.linear.residual[i], 1e-13);
    const Vector a = newtonStep(equation, e, e.linear);
    const Vector b = newtonStep(equation, e, held);
    for (std::size_t i = 0; i < a.size(); ++i)
      TEST_COMPARE(std::abs(a[i] - b[i]), <=, 1e-9 * (1 + std::abs(a[i])));
  }
}

/// Whatever the start, a step lands where the held set's conditions hold with equality.
TEUCHOS_UNIT_TEST(ActiveSets, aStepSolvesTheProblemOfTheSetThatItHolds) {
  std::mt19937 random(62);
  for (int k = 0; k < 30; ++k) {
    const char* laws[] = {"None", "Tresca", "Coulomb"};
    const Problem problem = stronglyCoupled(3, laws[k % 3], random);
    const Equation equation = equationOf(problem);
    contact::ActiveSet set;
    for (Index i = 0; i < problem.size(); ++i)
      set.push_back(static_cast<signed char>(i < problem.normals
                                                 ? static_cast<int>(random() % 2)
                                                 : static_cast<int>(random() % 3) - 1));
    const Evaluation e = equation.at(Vector(problem.offset.size(), 0.3));
    const Evaluation next =
        equation.at(afterStep(equation, e, holding(equation, e, set)));
    double scale = 1;
    for (const double x : next.unknowns)
      scale = std::max(scale, std::abs(x));
    for (const double f : holding(equation, next, set).residual)
      TEST_COMPARE(std::abs(f), <=, 1e-9 * scale);
  }
}

TEUCHOS_UNIT_TEST(ActiveSets, pivotingSolvesWhatNewtonCyclesOn) {
  std::mt19937 random(63);
  int cycles = 0;
  for (const char* law : {"None", "Tresca", "Coulomb"})
    for (int k = 0; k < 100; ++k) {
      const Problem problem = stronglyCoupled(1 + k % 6, law, random);
      const Equation equation = equationOf(problem);
      const Vector zero(problem.offset.size(), 0.0);
      cycles += stepsOfNewton(equation, zero, 200) == 200 ? 1 : 0;
      if (law != std::string("Coulomb"))
        TEST_COMPARE(stepsOfPivoting(equation, zero, 500), <, 500);
      const auto solution = solve(problem, {}, {});
      TEST_ASSERT(solution.report.status == contact::Status::Converged);
      TEST_COMPARE(reference::violation(problem, solution.state), <, 1e-9);
    }
  out << cycles << " of 300 cycle\n";
  TEST_COMPARE(cycles, >, 20);
}

// ½ λᵀDλ - d₀ᵀλ
double energy(const Problem& problem, const Vector& x) {
  double sum = 0;
  for (Index i = 0; i < problem.size(); ++i) {
    double row = -problem.offset[i];
    for (Index j = 0; j < problem.size(); ++j)
      row += 0.5 * problem.flexibility(i, j) * x[j];
    sum += x[i] * row;
  }
  return sum;
}

TEUCHOS_UNIT_TEST(Smoothing, staysInTheBoxAndLowersTheEnergy) {
  std::mt19937 random(64);
  for (int k = 0; k < 40; ++k) {
    const Problem problem = stronglyCoupled(4, k % 2 == 0 ? "None" : "Tresca", random);
    const Equation equation = equationOf(problem);
    const Vector start(problem.offset.size(), 0.1);
    const Evaluation e = equation.at(smoothed(equation, start));
    TEST_ASSERT(equation.projected(e) == e.unknowns);
    TEST_COMPARE(energy(problem, e.unknowns), <, energy(problem, start));
  }
}

TEUCHOS_UNIT_TEST(Smoothing, leavesASolutionAlone) {
  std::mt19937 random(65);
  test::Recipe recipe;
  recipe.law = "Coulomb";
  recipe.strength = 0.3;
  recipe.rigidMotions = 1;
  const Problem problem = randomProblem(recipe, random);
  const Equation equation = equationOf(problem);
  const Vector solution = pack(problem, solve(problem, {}, {}).state);
  TEST_ASSERT(smoothed(equation, solution) == solution);
}

}  // namespace

}  // namespace epafi
