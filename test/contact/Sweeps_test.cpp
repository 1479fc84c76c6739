#include "contact/newton/Sweeps.hpp"

#include "contact/RandomProblem.hpp"
#include "contact/Solve.hpp"
#include "contact/newton/NewtonSystem.hpp"
#include "reference/Violation.hpp"

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

/// The classical frictionless problem on which full steps from zero visit three active
/// sets for ever.
Problem cyclingProblem() {
  const double d[3][3] = {{9, -4, -5}, {-4, 5, 7}, {-5, 7, 10}};
  Problem problem;
  problem.normals = 3;
  contact::Matrix flexibility(3, 3);
  for (Index i = 0; i < 3; ++i)
    for (Index j = 0; j < 3; ++j)
      flexibility(i, j) = d[i][j];
  problem.flexibility = std::move(flexibility);
  problem.offset = {8, -3, -2};
  problem.rigid = contact::Matrix(3, 0);
  return problem;
}

/// Copies of the cycling problem for the normal coefficients, random tangential ones, and
/// a little random flexibility that couples them all.
Problem stronglyCoupled(Index copies, const char* law, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Problem block = cyclingProblem();
  Problem problem;
  problem.normals = 3 * copies;
  const Index tangentials = law == std::string("None") ? 0 : problem.normals;
  for (Index t = 0; t < tangentials; ++t)
    problem.tangentials.emplace_back(t, test::pointLaw(law, {0.2}));
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

TEUCHOS_UNIT_TEST(ActiveSets, fullStepsCycleWithPeriodThreeOnTheClassicalExample) {
  const Problem problem = cyclingProblem();
  const Equation equation = test::equationOf(problem);
  auto e = equation.at({0, 0, 0});
  std::vector<contact::ContactStates> sets;
  for (int step = 0; step < 9; ++step) {
    Vector x = e.unknowns;
    const Vector d = contact::NewtonSystem(equation, e).solve(e.residual);
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] -= d[i];
    e = equation.at(x);
    sets.push_back(e.states);
    TEST_ASSERT(!e.converged);
  }
  for (std::size_t k = 3; k < sets.size(); ++k) {
    TEST_ASSERT(sets[k] == sets[k - 3]);
    TEST_ASSERT(sets[k] != sets[k - 1]);
  }
}

/// Full steps from zero visit the same sets for ever on every third of these, about.
TEUCHOS_UNIT_TEST(ActiveSets, whatFullStepsCycleOnIsSolved) {
  std::mt19937 random(63);
  int cycles = 0;
  for (const char* law : {"None", "Tresca", "Coulomb"})
    for (int k = 0; k < 100; ++k) {
      const Problem problem = stronglyCoupled(1 + k % 6, law, random);
      const auto solution = solve(problem, {}, {});
      cycles += solution.report.stages.size() > 1 ? 1 : 0;
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
    const Equation equation = test::equationOf(problem);
    const Vector start(problem.offset.size(), 0.1);
    const Evaluation e = equation.at(smoothed(equation, start));
    TEST_ASSERT(equation.projected(e) == e.unknowns);
    TEST_COMPARE(energy(problem, e.unknowns), <, energy(problem, start));
  }
}

TEUCHOS_UNIT_TEST(Smoothing, leavesASolutionAlone) {
  std::mt19937 random(65);
  const Problem problem = randomProblem(test::Recipe::of("Coulomb", 0.3, 1), random);
  const Equation equation = test::equationOf(problem);
  const Vector solution = pack(problem, solve(problem, {}, {}).state);
  TEST_ASSERT(smoothed(equation, solution) == solution);
}

}  // namespace

}  // namespace epafi
