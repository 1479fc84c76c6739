#include "bem/base/Error.hpp"
#include "contact/RandomProblem.hpp"
#include "contact/solve/CoulombIteration.hpp"
#include "contact/solve/NewtonSystem.hpp"
#include "reference/ProjectedSor.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <random>
#include <sstream>

namespace epafi {

namespace {

using contact::Equation;
using contact::Problem;
using contact::SolverOptions;
using contact::Status;
using contact::Vector;

Problem someProblem(const char* law, contact::Index rigidMotions) {
  std::mt19937 random(21);
  test::Recipe recipe;
  recipe.law = law;
  recipe.strength = 0.4;
  recipe.rigidMotions = rigidMotions;
  return randomProblem(recipe, random);
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

double largest(const Vector& v) {
  double result = 0;
  for (const double value : v)
    result = std::max(result, std::abs(value));
  return result;
}

TEUCHOS_UNIT_TEST(Equation, jacobianIsTheDifferenceQuotient) {
  std::mt19937 random(22);
  for (const auto& function : contact::complementarities())
    for (contact::Index rigidMotions : {0, 2}) {
      const Problem problem = someProblem("Coulomb", rigidMotions);
      const Equation equation(problem, function, Equation::Bound::Differentiated, 1e-12);
      const Vector x = randomVector(static_cast<std::size_t>(equation.size()), random);
      const Vector d = randomVector(x.size(), random);
      const double h = 1e-7;
      const Vector up = equation.at(combined(x, h, d)).residual;
      const Vector down = equation.at(combined(x, -h, d)).residual;
      const Vector product = equation.jacobianTimes(equation.at(x), d);
      for (std::size_t i = 0; i < x.size(); ++i)
        TEST_COMPARE(std::abs(product[i] - (up[i] - down[i]) / (2 * h)), <, 1e-5);
    }
}

TEUCHOS_UNIT_TEST(Equation, meritGradientIsTheDifferenceQuotient) {
  std::mt19937 random(23);
  for (contact::Index rigidMotions : {0, 2}) {
    const Problem problem = someProblem("Coulomb", rigidMotions);
    const Equation equation(problem, contact::complementarity("Projection"),
                            Equation::Bound::Differentiated, 1e-12);
    const Vector x = randomVector(static_cast<std::size_t>(equation.size()), random);
    const Vector d = randomVector(x.size(), random);
    const double h = 1e-6;
    const double quotient = (equation.merit(equation.at(combined(x, h, d))) -
                             equation.merit(equation.at(combined(x, -h, d)))) /
                            (2 * h);
    const Vector gradient = equation.meritGradient(equation.at(x));
    double slope = 0;
    for (std::size_t i = 0; i < d.size(); ++i)
      slope += gradient[i] * d[i];
    TEST_COMPARE(std::abs(slope - quotient), <, 1e-6 * std::abs(slope));
  }
}

/// Cholesky's way and LU's way through the elimination, with and without rigid motions.
TEUCHOS_UNIT_TEST(NewtonSystem, invertsTheJacobian) {
  std::mt19937 random(24);
  for (const auto& function : contact::complementarities())
    for (const auto bound : {Equation::Bound::Differentiated, Equation::Bound::Lagged})
      for (contact::Index rigidMotions : {0, 1, 2, 3}) {
        const Problem problem = someProblem("Coulomb", rigidMotions);
        const Equation equation(problem, function, bound, 1e-12);
        for (int k = 0; k < 10; ++k) {
          const auto e = equation.at(
              randomVector(static_cast<std::size_t>(equation.size()), random));
          const Vector b = randomVector(e.unknowns.size(), random);
          const contact::NewtonSystem system(equation, e);
          if (!system.unheld(b).empty())
            continue;
          const Vector d = system.solve(b);
          const Vector defect = combined(equation.jacobianTimes(e, d), -1, b);
          TEST_COMPARE(largest(defect), <, 1e-11 * (1 + largest(d)));
        }
      }
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

TEUCHOS_UNIT_TEST(NewtonOptions, aUsersLineSearchIsUsed) {
  for (const char* method : {"Full Step", "Backtrack", "Polynomial"})
    for (const char* law : {"None", "Tresca", "Coulomb"})
      for (contact::Index rigidMotions : {0, 1}) {
        const Problem problem = someProblem(law, rigidMotions);
        SolverOptions options;
        options.complementarity = SolverOptions::Complementarity::FischerBurmeister;
        options.nox = std::make_shared<Teuchos::ParameterList>("NOX");
        options.nox->sublist("Line Search").set("Method", method);
        // Twice with one list, as on two levels of a run.
        for (int level = 0; level < 2; ++level) {
          const auto solution = solve(problem, {}, options);
          TEST_ASSERT(solution.report.status == Status::Converged);
          TEST_COMPARE(reference::violation(problem, solution.state), <, 1e-10);
        }
        TEST_ASSERT(options.nox->isSublist("Direction"));  // filled in
      }
}

TEUCHOS_UNIT_TEST(NewtonOptions, whatNoxLeavesUnusedIsAnErrorWithItsPath) {
  SolverOptions options;
  options.nox = std::make_shared<Teuchos::ParameterList>("NOX");
  options.nox->sublist("Line Search").set("Metod", "Backtrack");
  try {
    solve(someProblem("Tresca", 0), {}, options);
    TEST_ASSERT(false);
  } catch (const bem::InputError& error) {
    TEST_ASSERT(std::string(error.what()).find("Solver->NOX->Line Search->Metod") !=
                std::string::npos);
  }
}

TEUCHOS_UNIT_TEST(NewtonOptions, whatNoxRefusesIsAnInputError) {
  for (const char* sublist : {"Line Search", "Direction"}) {
    SolverOptions options;
    options.nox = std::make_shared<Teuchos::ParameterList>("NOX");
    options.nox->sublist(sublist).set("Method", "Crystal Ball");
    TEST_THROW(solve(someProblem("Tresca", 0), {}, options), bem::InputError);
  }
  SolverOptions options;
  options.nox = std::make_shared<Teuchos::ParameterList>("NOX");
  options.nox->set("Nonlinear Solver", "Trust Region Based");
  TEST_THROW(solve(someProblem("Tresca", 0), {}, options), bem::InputError);
}

}  // namespace

}  // namespace epafi
