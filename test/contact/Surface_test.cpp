// Normal laws, and problems whose surfaces yield.
#include "contact/RandomProblem.hpp"
#include "contact/Solve.hpp"
#include "reference/Violation.hpp"

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>

namespace epafi {

namespace {

using contact::Index;
using contact::Vector;

constexpr const char* laws[] = {"Linear", "Root", "Square", "Exponential"};

double relative(double a, double b) { return std::abs(a - b) / std::abs(b); }

TEUCHOS_UNIT_TEST(Surface, lawsAreConsistent) {
  for (const char* name : laws) {
    const contact::PointClosing law = test::pointClosing(name, 0.3);
    TEST_EQUALITY(law.closing(0), 0);
    TEST_FLOATING_EQUALITY(law.slope(1), 0.3, 1e-14);
    for (const double p : {1e-3, 0.02, 0.7, 5.0}) {
      const double h = 1e-5 * p;
      const auto quotient = [&](const auto& f) {
        return (f(p + h) - f(p - h)) / (2 * h);
      };
      const double slope = quotient([&](double x) { return law.closing(x); });
      const double work = quotient([&](double x) { return law.energy(x); });
      TEST_COMPARE(relative(slope, law.slope(p)), <, 1e-8);
      TEST_COMPARE(relative(work, p * law.slope(p)), <, 1e-8);
      for (const double c : {0.0, 1e-6, 1.0, 1e8})
        TEST_COMPARE(relative(law.resolvent(c, p + c * law.closing(p)), p), <, 1e-13);
    }
  }
}

TEUCHOS_UNIT_TEST(Surface, unitsCancel) {
  const contact::Normal normal = contact::makeNormal(
      "Exponential", {[](bem::Vec2) { return 0.002; }, [](bem::Vec2) { return 7.0; }});
  const contact::PointClosing here = normal.at({}, {1, 1});
  const contact::PointClosing there = normal.at({}, {10, 210});
  TEST_FLOATING_EQUALITY(10 * there.closing(5.0 / 210), here.closing(5), 1e-14);
  TEST_FLOATING_EQUALITY(10.0 / 210 * there.slope(5.0 / 210), here.slope(5), 1e-14);
  TEST_FLOATING_EQUALITY(2100 * there.energy(5.0 / 210), here.energy(5), 1e-14);
}

// φ = L ln(1 + p/P) is L p/P where p is small
TEUCHOS_UNIT_TEST(Surface, aStiffExponentialLawStoresWhatALinearOneDoes) {
  const contact::Normal stiff = contact::makeNormal(
      "Exponential", {[](bem::Vec2) { return 5e12; }, [](bem::Vec2) { return 1e13; }});
  TEST_FLOATING_EQUALITY(stiff.at({}, {1, 1}).energy(0.1), 0.25 * 0.01, 1e-13);
}

contact::Problem drawn(const char* normal, const char* law, std::mt19937& random) {
  test::Recipe recipe = test::Recipe::of(law, 0.5, 1);
  recipe.normal = normal;
  return test::randomProblem(recipe, random);
}

TEUCHOS_UNIT_TEST(Surface, tangentsTouch) {
  std::mt19937 random(9);
  for (const char* normal : laws) {
    const contact::Problem problem = drawn(normal, "Coulomb", random);
    const contact::Solution solution = test::solve(problem);
    const contact::Equation equation = test::equationOf(problem, 0);
    const contact::Problem linear =
        equation.withTangent(equation.at(pack(problem, solution.state)));
    TEST_ASSERT(linear.surface.places.empty());
    TEST_COMPARE(reference::violation(problem, solution.state), <, 1e-10);
    TEST_COMPARE(reference::violation(linear, solution.state), <, 1e-10);
    TEST_COMPARE(reference::violation(linear, test::solve(linear).state), <, 1e-10);
  }
}

// What a law stores is what makes r follow from the minimum of an energy.
TEUCHOS_UNIT_TEST(Surface, closingIsTheGradientOfTheComplementaryEnergy) {
  std::mt19937 random(10);
  for (const char* normal : laws) {
    const contact::Problem problem = drawn(normal, "Tresca", random);
    Vector x(static_cast<std::size_t>(problem.size()));
    for (double& value : x)
      value = std::uniform_real_distribution<double>(0.1, 1)(random);
    // λ·Φ less what is stored is ∫ Φ dλ
    const auto complementary = [&](const Vector& at) {
      const Vector closing = problem.surface.closing(at);
      double sum = -problem.surface.energy(at);
      for (std::size_t i = 0; i < at.size(); ++i)
        sum += at[i] * closing[i];
      return sum;
    };
    const Vector closing = problem.surface.closing(x);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double h = 1e-5;
      Vector more = x;
      Vector less = x;
      more[i] += h;
      less[i] -= h;
      const double quotient = (complementary(more) - complementary(less)) / (2 * h);
      TEST_COMPARE(std::abs(quotient - closing[i]), <, 1e-7);
    }
  }
}

}  // namespace

}  // namespace epafi
