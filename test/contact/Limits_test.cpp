// At the limits of what can be held: bodies that float, slide as a whole, or are given no
// numbers.
#include "Message.hpp"
#include "contact/RandomProblem.hpp"
#include "contact/Solve.hpp"
#include "contact/equation/Equation.hpp"
#include "contact/equation/Equilibrium.hpp"
#include "reference/Violation.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace epafi {

namespace {

using contact::Index;
using contact::Problem;
using contact::Solution;
using contact::Status;
using test::Recipe;
using test::solve;
using test::SolverOptions;

/// One point on a spring:  D λ = d₀ + α, λ = q.
Problem floatingPoint(double gap, double load) {
  Problem problem;
  problem.normals = 1;
  problem.flexibility = test::identity(1, 2);
  problem.offset = {-gap};
  problem.rigid = contact::Matrix(1, 1);
  problem.rigid(0, 0) = 1;
  problem.rigidLoad = {load};
  return problem;
}

TEUCHOS_UNIT_TEST(Limits, aFloatingBodyComesToRestHoweverLargeTheGap) {
  for (double gap : {0.0, 1e-9, 1.0, 1e6, -1e3}) {
    const Solution solution = solve(floatingPoint(gap, 3));
    TEST_ASSERT(solution.report.status == Status::Converged);
    TEST_COMPARE(std::abs(solution.state.multiplier[0] - 3), <, 1e-9);
    TEST_COMPARE(std::abs(solution.state.rigid[0] - (6 + gap)), <,
                 1e-9 * (1 + std::abs(gap)));
  }
}

TEUCHOS_UNIT_TEST(Limits, aLoadThatNothingHoldsIsAnErrorThatSaysSo) {
  TEST_THROW(solve(floatingPoint(1, -3)), contact::NoBalance);
}

/// Contact would hold it: the reason is another one than that nothing does.
TEUCHOS_UNIT_TEST(Limits, aGapBeyondAllMeasureIsNoMotionThatNothingHolds) {
  const std::string told =
      test::messageOf<contact::NoBalance>([] { solve(floatingPoint(1e14, 3)); });
  TEST_ASSERT(!told.empty() && told != contact::NoBalance().what());
}

/// λ balances the load, but it is open there, however r is rounded.
TEUCHOS_UNIT_TEST(Limits, pressureFarFromContactIsNoSolution) {
  const Problem problem = floatingPoint(0, 3);
  const contact::Equation equation = test::equationOf(problem, 1e-10);
  TEST_ASSERT(equation.at({3, 6}).converged);
  TEST_ASSERT(!equation.at({3, -1e17}).converged);
}

/// A floating block of two points, pressed down alike, the first three times as stiff: pushed
/// sideways it takes three quarters until it slips, the second the rest until all slide.
TEUCHOS_UNIT_TEST(Limits, frictionAloneHoldsABodyUpToGlobalSliding) {
  Problem problem = test::block(0.5, {});
  contact::Matrix flexibility = test::identity(4);
  flexibility(3, 3) = 3;
  problem.flexibility = std::move(flexibility);
  for (const auto coulomb : {"Newton", "Inexact Fixed Point", "Fixed Point"}) {
    SolverOptions options;
    options.coulomb.iteration = coulomb;
    for (const double push : {0.6, 0.9, 0.99999, -0.9}) {
      problem.rigidLoad = {2, push};
      const Solution held = solve(problem, {}, options);
      TEST_ASSERT(held.report.status == Status::Converged);
      const double first = std::clamp(0.75 * push, -0.5, 0.5);
      TEST_COMPARE(std::abs(held.state.multiplier[2] - first), <, 1e-9);
      TEST_COMPARE(std::abs(held.state.multiplier[3] - (push - first)), <, 1e-9);
      TEST_COMPARE(std::abs(held.state.rigid[1] - 3 * (push - first)), <, 1e-9);
    }
    problem.rigidLoad = {2, 1.1};
    const std::string refused = test::messageOf<bem::NumericalError>([&] {
      if (!solve(problem, {}, options).report.converged())
        throw bem::NumericalError("not converged");
    });
    TEST_ASSERT(!refused.empty());
  }
}

/// A pad on two points, pressed by q and pulled along, both by springs as well:
///   λₙ + λₙ' + K α = q,  μ q at most along.
TEUCHOS_UNIT_TEST(Limits, softSpringsWantNoOtherStageThanNewtons) {
  for (const double stiffness : {1.0, 1e-3, 1e-6, 1e-9})
    for (const double gap : {0.0, 3.0})
      for (const double pull : {0.5, 0.9, -0.9}) {
        const double press = 1 + stiffness * (0.5 + gap);  // λₙ = 1/2 each
        Problem problem = test::block(0.6, {press, pull});
        problem.offset = {-gap, -gap, 0, 0};
        problem.rigidStiffness = {stiffness, stiffness};
        const Solution solution = solve(problem);
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

TEUCHOS_UNIT_TEST(Limits, tooFewStepsAreReportedByEveryStage) {
  std::mt19937 random(18);
  const Problem problem = test::randomProblem({30, "Tresca"}, random);
  SolverOptions options;
  options.contact.maximumIterations = 1;
  const auto report = solve(problem, {}, options).report;
  TEST_ASSERT(report.status == Status::NotConverged);
  TEST_COMPARE(report.stages.size(), >, 1);
  for (const contact::StageRun& stage : report.stages)
    TEST_ASSERT(stage.end == contact::End::Iterations);
  TEST_ASSERT(!report.changing.empty());
}

TEUCHOS_UNIT_TEST(Limits, brokenNumbersAreErrors) {
  std::mt19937 random(19);
  Problem problem = test::randomProblem({5, "Tresca"}, random);
  problem.offset[2] = std::numeric_limits<double>::quiet_NaN();
  TEST_THROW(solve(problem, {}, {}), bem::NumericalError);
  problem = test::randomProblem({5, "None"}, random);
  contact::Matrix infinite = problem.flexibility.entries().copy();
  infinite(1, 3) = infinite(3, 1) = std::numeric_limits<double>::infinity();
  problem.flexibility = std::move(infinite);
  TEST_THROW(solve(problem, {}, {}), bem::NumericalError);
  // Two coefficients that are one and the same.
  problem = test::randomProblem({2, "None"}, random);
  contact::Matrix ones(2, 2);
  for (Index i = 0; i < 2; ++i)
    ones(i, 0) = ones(i, 1) = 1;
  problem.flexibility = std::move(ones);
  problem.offset = {1, 1};
  const auto solution = [&] { return solve(problem, {}, {}); };
  TEST_THROW(solution(), bem::NumericalError);
}

/// A half-plane's side of length 1, by two points of each element, on a rigid parabola: a force of 1
/// at x = `place` presses it flat over about 2 a, where its elements are small.
Problem narrowContact(double a, double place) {
  contact::Vector nodes = {-0.5, -0.25, -0.05, 0.05, 0.25, 0.5};
  for (int k = -32; k <= 32; ++k)
    nodes.push_back(a * k / 8);
  std::sort(nodes.begin(), nodes.end());
  contact::Vector x;
  contact::Vector lengths;
  for (std::size_t e = 0; e + 1 < nodes.size(); ++e)
    for (const double t : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}) {
      lengths.push_back((nodes[e + 1] - nodes[e]) / 2);
      x.push_back((nodes[e + 1] + nodes[e]) / 2 + t * lengths.back());
    }
  const double pi = std::acos(-1.0);
  const auto n = static_cast<Index>(x.size());
  Problem problem;
  problem.normals = n;
  contact::Matrix d(n, n);
  problem.rigid = contact::Matrix(n, 2);
  for (Index i = 0; i < n; ++i) {
    const double length = lengths[bem::at(i)];
    const double own = x[bem::at(i)];
    for (Index j = 0; j < n; ++j)
      d(i, j) = length * lengths[bem::at(j)] / pi *
                (i == j ? 1.5 - std::log(length)
                        : 0.7 - std::log(std::abs(own - x[bem::at(j)])));
    problem.offset.push_back(-length * own * own / (a * a * pi));
    problem.rigid(i, 0) = length;
    problem.rigid(i, 1) = length * own;
  }
  problem.flexibility = std::move(d);
  problem.rigidLoad = {1, place};
  problem.stress = 2 / (pi * a);
  return problem;
}

TEUCHOS_UNIT_TEST(Limits, aNarrowContactHoldsARotation) {
  for (const double a : {1e-2, 1e-4, 1e-5, 2e-6}) {
    const Problem problem = narrowContact(a, 0.3 * a);
    const Solution solution = solve(problem);
    TEST_ASSERT(solution.report.status == Status::Converged);
    double moment = 0;
    for (Index i = 0; i < problem.normals; ++i)
      moment += problem.rigid(i, 1) * solution.state.multiplier[bem::at(i)];
    TEST_COMPARE(std::abs(moment - 0.3 * a), <, 1e-9 * a);
  }
}

}  // namespace

}  // namespace epafi
