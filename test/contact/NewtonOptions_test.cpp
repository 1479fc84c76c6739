#include "Largest.hpp"
#include "Message.hpp"
#include "contact/RandomProblem.hpp"
#include "contact/Solve.hpp"
#include "contact/equation/Equation.hpp"
#include "contact/newton/NewtonSystem.hpp"
#include "reference/Violation.hpp"

#include <NOX_Abstract_Group.H>
#include <NOX_LineSearch_Generic.H>
#include <NOX_LineSearch_UserDefinedFactory.H>
#include <NOX_Solver_Generic.H>
#include <Teuchos_ParameterList.hpp>
#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <numeric>
#include <random>
#include <sstream>

namespace epafi {

namespace {

using contact::Equation;
using contact::Problem;
using contact::Status;
using contact::Vector;
using test::largest;
using test::solve;
using test::SolverOptions;

Problem someProblem(const char* law, contact::Index rigidMotions) {
  std::mt19937 random(21);
  return randomProblem(test::Recipe::of(law, 0.4, rigidMotions), random);
}

std::shared_ptr<const Teuchos::ParameterList> lineSearch(const char* key,
                                                         const char* value) {
  const auto list = std::make_shared<Teuchos::ParameterList>("NOX");
  list->sublist("Line Search").set(key, value);
  return list;
}

Vector randomVector(std::size_t size, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Vector v(size);
  for (double& value : v)
    value = normal(random);
  return v;
}

Vector combined(const Vector& a, double factor, const Vector& b) {
  Vector result = a;
  for (std::size_t i = 0; i < a.size(); ++i)
    result[i] += factor * b[i];
  return result;
}

double product(const Vector& a, const Vector& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// Where a normal law yields, near the solution: its slopes are wild elsewhere.
TEUCHOS_UNIT_TEST(Equation, jacobianIsTheDifferenceQuotientAndHasATransposeAndAnInverse) {
  std::mt19937 random(22);
  for (const char* normal : {"Rigid", "Linear", "Root", "Square", "Exponential"})
    for (const char* law : {"None", "Tresca", "Coulomb"})
      for (int k = 0; k < 6; ++k) {
        test::Recipe recipe = test::Recipe::of(law, 0.5, k % 3);
        recipe.normal = normal;
        recipe.springs = k < 3 ? 0 : 2;
        const Problem problem = randomProblem(recipe, random);
        const bool yields = !problem.surface.places.empty();
        const Equation equation = test::equationOf(problem, yields ? 0 : 1e-12);
        Vector x = randomVector(equation.size(), random);
        if (yields) {
          const contact::Solution solution = solve(problem);
          TEST_ASSERT(solution.report.converged());
          x = combined(pack(problem, solution.state), 5e-4, x);
        }
        const contact::Evaluation e = equation.at(x);
        const Vector d = randomVector(x.size(), random);
        const Vector dual = randomVector(x.size(), random);
        const double h = 1e-7;
        const Vector rise = combined(equation.at(combined(x, h, d)).residual, -1,
                                     equation.at(combined(x, -h, d)).residual);
        const Vector image = equation.jacobianTimes(e, d);
        TEST_COMPARE(largest(combined(image, -0.5 / h, rise)), <, 1e-5);
        const double paired = product(dual, image);
        TEST_COMPARE(std::abs(paired - product(equation.transposeTimes(e, dual), d)), <,
                     1e-12 * (1 + std::abs(paired)));
        // the balance is linear
        const Vector none = equation.at(Vector(x.size(), 0.0)).residual;
        const Vector jx = equation.jacobianTimes(e, x);
        for (auto j = bem::at(problem.size()); j < x.size(); ++j)
          TEST_COMPARE(std::abs(none[j] + jx[j] - e.residual[j]), <,
                       1e-12 * (1 + std::abs(jx[j])));
        if (!yields)
          continue;  // a pressure below zero may be held by nothing
        const Vector back = contact::NewtonSystem(equation, e).solve(image);
        for (std::size_t i = 0; i < d.size(); ++i)
          TEST_FLOATING_EQUALITY(back[i], d[i], 1e-7);
      }
}

TEUCHOS_UNIT_TEST(Equation, meritGradientIsTheDifferenceQuotient) {
  std::mt19937 random(23);
  for (contact::Index rigidMotions : {0, 2}) {
    const Problem problem = someProblem("Coulomb", rigidMotions);
    const Equation equation = test::equationOf(problem);
    const Vector x = randomVector(equation.size(), random);
    const Vector d = randomVector(x.size(), random);
    const double h = 1e-6;
    const double quotient = (merit(equation, equation.at(combined(x, h, d))) -
                             merit(equation, equation.at(combined(x, -h, d)))) /
                            (2 * h);
    const Vector gradient = meritGradient(equation, equation.at(x));
    const double slope = product(gradient, d);
    TEST_COMPARE(std::abs(slope - quotient), <, 1e-6 * std::abs(slope));
  }
}

/// Cholesky's way and LU's way through the elimination, with and without rigid motions.
TEUCHOS_UNIT_TEST(NewtonSystem, invertsTheJacobian) {
  std::mt19937 random(24);
  int solved = 0;
  for (const auto bound : {Equation::Bound::Differentiated, Equation::Bound::Lagged})
    for (contact::Index rigidMotions : {0, 1, 2, 3}) {
      const Problem problem = someProblem("Coulomb", rigidMotions);
      const Equation equation(problem, bound, 1e-12);
      for (int k = 0; k < 20; ++k) {
        const auto e = equation.at(randomVector(equation.size(), random));
        const Vector b = randomVector(e.unknowns.size(), random);
        const contact::NewtonSystem system(equation, e);
        if (!system.unheld(b).empty())
          continue;
        ++solved;
        const Vector d = system.solve(b);
        const Vector defect = combined(equation.jacobianTimes(e, d), -1, b);
        TEST_COMPARE(largest(defect), <, 1e-11 * (1 + largest(d)));
      }
    }
  TEST_COMPARE(solved, >=, 150);  // of 160; nothing holds the body in the others
}

TEUCHOS_UNIT_TEST(NewtonOptions, noxPrintsNothingUnasked) {
  std::ostringstream text;
  auto* const screen = std::cout.rdbuf(text.rdbuf());
  auto* const log = std::cerr.rdbuf(text.rdbuf());
  solve(someProblem("Coulomb", 1), {}, {});
  std::cout.rdbuf(screen);
  std::cerr.rdbuf(log);
  TEST_EQUALITY(text.str(), "");
}

/// Takes whole steps, and counts.
class CountingSearch final : public NOX::LineSearch::Generic {
 public:
  explicit CountingSearch(int& count) : count_(count) {}
  bool compute(NOX::Abstract::Group& group, double& step,
               const NOX::Abstract::Vector& direction,
               const NOX::Solver::Generic& solver) override {
    step = 1;
    ++count_;
    group.computeX(solver.getPreviousSolutionGroup(), direction, step);
    return group.computeF() == NOX::Abstract::Group::Ok;
  }

 private:
  int& count_;
};

class CountingFactory final : public NOX::LineSearch::UserDefinedFactory {
 public:
  explicit CountingFactory(int& count) : count_(count) {}
  Teuchos::RCP<NOX::LineSearch::Generic> buildLineSearch(
      const Teuchos::RCP<NOX::GlobalData>&, Teuchos::ParameterList&) const override {
    return Teuchos::rcp(new CountingSearch(count_));
  }

 private:
  int& count_;
};

/// In every run of a solve, from zero and from a state that is known; the list stays as it
/// was.
TEUCHOS_UNIT_TEST(NewtonOptions, aUsersLineSearchMakesEveryStep) {
  for (const char* law : {"None", "Tresca", "Coulomb"})
    for (contact::Index rigidMotions : {0, 1}) {
      Problem problem = someProblem(law, rigidMotions);
      int searches = 0;
      const auto list = std::make_shared<Teuchos::ParameterList>("NOX");
      list->sublist("Line Search").set("Method", "User Defined");
      list->sublist("Line Search")
          .set<Teuchos::RCP<NOX::LineSearch::UserDefinedFactory>>(
              "User Defined Line Search Factory",
              Teuchos::rcp(new CountingFactory(searches)));
      const Teuchos::ParameterList before = *list;
      SolverOptions options;
      options.nox = list;
      const auto cold = solve(problem, {}, options);
      TEST_ASSERT(cold.report.status == Status::Converged);
      TEST_EQUALITY(searches, cold.report.newtonIterations);

      searches = 0;
      for (double& d : problem.offset)
        d *= 1 + 1e-4;
      const auto warm = solve(problem, cold.state, options);
      TEST_ASSERT(warm.report.status == Status::Converged);
      TEST_EQUALITY(searches, warm.report.newtonIterations);
      TEST_COMPARE(searches, >, 0);
      TEST_ASSERT(*list == before);
    }
}

/// NOX's own line searches see the smooth merit function and find the solution.
TEUCHOS_UNIT_TEST(NewtonOptions, noxSearchesLeadToTheSolution) {
  for (const char* method : {"Full Step", "Backtrack", "Polynomial"})
    for (const char* law : {"None", "Tresca", "Coulomb"})
      for (contact::Index rigidMotions : {0, 1}) {
        const Problem problem = someProblem(law, rigidMotions);
        SolverOptions options;
        options.nox = lineSearch("Method", method);
        const auto solution = solve(problem, {}, options);
        TEST_ASSERT(solution.report.status == Status::Converged);
        TEST_COMPARE(reference::violation(problem, solution.state), <, 1e-10);
      }
}

/// Each step lessens the merit, from far away.
TEUCHOS_UNIT_TEST(NewtonOptions, theMeritFallsAlongASearch) {
  std::mt19937 random(25);
  for (const char* law : {"Tresca", "Coulomb"})
    for (int k = 0; k < 20; ++k) {
      const Problem problem = randomProblem(test::Recipe::of(law, 3), random);
      const Equation equation = test::equationOf(problem);
      Vector start = randomVector(equation.size(), random);
      for (double& x : start)
        x *= 10 * problem.stress;
      const contact::NewtonRun run =
          contact::NoxNewton(lineSearch("Method", "Backtrack")).run(equation, start, 50);
      TEST_EQUALITY(run.merits.size(), run.setChanges.size() + 1);
      for (std::size_t i = 1; i < run.merits.size(); ++i)
        TEST_COMPARE(run.merits[i], <=, run.merits[i - 1]);
      TEST_FLOATING_EQUALITY(
          run.merits.front(),
          std::sqrt(2 * merit(equation, equation.at(start))) / problem.stress, 1e-12);
    }
}

/// A looser test of the user's ends a run; one that forbids all steps fails it.
TEUCHOS_UNIT_TEST(NewtonOptions, statusTestsOfTheUserCount) {
  const Problem problem = someProblem("Coulomb", 0);
  const Equation equation = test::equationOf(problem);
  const Vector zero(bem::at(equation.size()), 0.0);
  const contact::NewtonRun full = contact::NoxNewton().run(equation, zero, 50);
  const auto list = std::make_shared<Teuchos::ParameterList>("NOX");
  Teuchos::ParameterList& tests = list->sublist("Status Tests");
  tests.set("Test Type", "NormF").set("Tolerance", 0.5 * problem.stress);
  const contact::NewtonRun loose = contact::NoxNewton(list).run(equation, zero, 50);
  TEST_ASSERT(loose.end == contact::End::Converged);
  TEST_COMPARE(loose.iterations, <, full.iterations);
  TEST_COMPARE(loose.residual, >, full.residual);
  TEST_EQUALITY(loose.tolerance, loose.residual);
  tests = Teuchos::ParameterList("Status Tests");
  tests.set("Test Type", "MaxIters").set("Maximum Iterations", 1);
  const contact::NewtonRun one = contact::NoxNewton(list).run(equation, zero, 50);
  TEST_EQUALITY(one.iterations, 1);
  TEST_ASSERT(one.end == contact::End::Stalled);
  tests.set("Toleranz", 1.0);
  const std::string told =
      test::messageOf([&] { contact::NoxNewton(list).run(equation, zero, 50); });
  out << told << "\n";
  TEST_ASSERT(test::contains(told, "Toleranz") &&
              test::contains(told, "NOX->Status Tests") &&
              !test::contains(told, "Throw"));
}

/// Newton's systems by Belos on products with the Jacobian.
TEUCHOS_UNIT_TEST(NewtonOptions, belosSolvesNewtonsSystems) {
  const auto list = std::make_shared<Teuchos::ParameterList>("NOX");
  Teuchos::ParameterList& newton = list->sublist("Direction").sublist("Newton");
  newton.sublist("Linear Solver").set("Tolerance", 1e-13);
  Teuchos::ParameterList& stratimikos =
      newton.sublist("Stratimikos Linear Solver").sublist("Stratimikos");
  stratimikos.set("Linear Solver Type", "Belos");
  stratimikos.sublist("Linear Solver Types")
      .sublist("Belos")
      .set("Solver Type", "Block GMRES")
      .sublist("Solver Types")
      .sublist("Block GMRES")
      .set("Maximum Iterations", 500)
      .set("Num Blocks", 500);
  for (const char* law : {"None", "Tresca", "Coulomb"}) {
    const Problem problem = someProblem(law, 0);
    SolverOptions options;
    options.nox = list;
    const auto byProducts = solve(problem, {}, options);
    const auto direct = solve(problem);
    TEST_ASSERT(byProducts.report.converged());
    TEST_EQUALITY(byProducts.report.stages.size(), direct.report.stages.size());
    TEST_COMPARE(
        largest(combined(byProducts.state.multiplier, -1, direct.state.multiplier)), <,
        1e-9 * problem.stress);
  }
  stratimikos.set("Linear Solver Type", "Amesos");
  TEST_ASSERT(test::contains(test::messageOf([&] {
                               SolverOptions options;
                               options.nox = list;
                               solve(someProblem("Tresca", 0), {}, options);
                             }),
                             "Linear Solver Type = 'Amesos'; allowed: 'Belos'"));
}

/// A step that goes a part of the way leaves most of the residual, which is no rounding then.
TEUCHOS_UNIT_TEST(NewtonOptions, shortStepsDoNotLeaveRounding) {
  const Problem problem = someProblem("Tresca", 0);
  const Equation equation = test::equationOf(problem);
  Vector start = pack(problem, solve(problem).state);
  for (double& x : start)
    x *= 1 + 1e-9;
  const auto list = std::make_shared<Teuchos::ParameterList>("NOX");
  list->sublist("Line Search").sublist("Full Step").set("Full Step", 0.08);
  const contact::NewtonRun run = contact::NoxNewton(list).run(equation, start, 200);
  TEST_ASSERT(run.end == contact::End::Converged);
  TEST_COMPARE(equation.at(start).scaled, >, 1e-11);
  TEST_COMPARE(run.residual, <=, 1e-12);
  TEST_COMPARE(run.iterations, >, 20);
}

/// s = √p
class RootOfPressure final : public contact::FrictionLaw {
 public:
  double bound(double pressure, const Vector& /*fields*/) const override {
    return std::sqrt(pressure);
  }
  double slope(double pressure, const Vector& /*fields*/) const override {
    return 0.5 / std::sqrt(pressure);
  }
};

/// Two closed points that slip, D_nn nearly singular: the tangent of the bound at small pressures
/// is far from the bound at the solution, so that a step of the same active set leaves hundreds of
/// times the residual; the next one solves.
TEUCHOS_UNIT_TEST(NewtonOptions, aBoundThatBendsIsNoCycle) {
  Problem problem;
  problem.normals = 2;
  contact::Matrix flexibility(4, 4);
  for (contact::Index i = 0; i < 4; ++i)
    flexibility(i, i) = 1;
  flexibility(0, 1) = flexibility(1, 0) = -0.99;
  problem.flexibility = std::move(flexibility);
  for (const contact::Index normal : {0, 1})
    problem.tangentials.emplace_back(
        normal, contact::PointLaw(std::make_shared<const RootOfPressure>(), {}, 1));
  problem.offset = {0.02, 0.02, 100, 100};
  problem.rigid = contact::Matrix(4, 0);
  const Equation equation = test::equationOf(problem);
  const double start = 1e-3;
  const contact::NewtonRun run = contact::NoxNewton().run(
      equation, {start, start, std::sqrt(start), std::sqrt(start)}, 10);
  TEST_ASSERT(run.end == contact::End::Converged);
  const Vector exact = {2, 2, std::sqrt(2.0), std::sqrt(2.0)};
  TEST_COMPARE(largest(combined(run.last, -1, exact)), <, 1e-10);
}

TEUCHOS_UNIT_TEST(NewtonOptions, whatNoxLeavesUnusedIsAnErrorWithItsPath) {
  SolverOptions options;
  options.nox = lineSearch("Metod", "Backtrack");
  const std::string told =
      test::messageOf([&] { solve(someProblem("Tresca", 0), {}, options); });
  TEST_ASSERT(test::contains(told, "NOX->Line Search->Metod"));
}

TEUCHOS_UNIT_TEST(NewtonOptions, whatNoxRefusesIsAnInputError) {
  for (const auto& [sublist, method] : {std::pair("Line Search", "Crystal Ball"),
                                        {"Direction", "Crystal Ball"},
                                        {"Line Search", "More'-Thuente"},
                                        {"Line Search", "Safeguarded Step"}}) {
    const auto list = std::make_shared<Teuchos::ParameterList>("NOX");
    list->sublist(sublist).set("Method", method);
    SolverOptions options;
    options.nox = list;
    const std::string told =
        test::messageOf([&] { solve(someProblem("Tresca", 0), {}, options); });
    out << told << "\n";
    TEST_ASSERT(!told.empty());
    TEST_ASSERT(!test::contains(told, "Throw"));
    if (std::string(sublist) == "Line Search")
      TEST_ASSERT(test::contains(told, "NOX->Line Search->Method"));
  }
  const auto list = std::make_shared<Teuchos::ParameterList>("NOX");
  list->set("Nonlinear Solver", "Trust Region Based");
  SolverOptions options;
  options.nox = list;
  TEST_THROW(solve(someProblem("Tresca", 0), {}, options), bem::InputError);
}

}  // namespace

}  // namespace epafi
