// Slip bounds that follow a pressure, with the slopes that differences show.
#include "contact/RandomProblem.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>
#include <random>

namespace epafi {

namespace {

using contact::Problem;
using contact::Tangential;
using contact::Vector;

Problem coulombProblem(std::mt19937& random) {
  test::Recipe recipe;
  recipe.law = "Coulomb";
  return randomProblem(recipe, random);
}

/// Pressures of which some are negative.
Vector somePressures(const Problem& problem, std::mt19937& random) {
  Vector pressures;
  for (contact::Index i = 0; i < problem.normals; ++i)
    pressures.push_back(std::uniform_real_distribution<double>(-0.3, 1)(random));
  return pressures;
}

TEUCHOS_UNIT_TEST(Tangential, slopesAreTheDerivativeAwayFromKinks) {
  std::mt19937 random(42);
  const double h = 1e-7;
  int sloping = 0;
  for (int k = 0; k < 20; ++k) {
    const Problem problem = coulombProblem(random);
    const Vector pressures = somePressures(problem, random);
    Vector more = pressures;
    Vector less = pressures;
    for (std::size_t i = 0; i < pressures.size(); ++i) {
      more[i] += h;
      less[i] -= h;
    }
    for (const Tangential& t : problem.tangentials) {
      const double slope = t.slope(pressures);
      TEST_COMPARE(std::abs((t.bound(more) - t.bound(less)) / (2 * h) - slope), <, 1e-6);
      TEST_COMPARE(slope, <=, t.steepest());
      sloping += slope > 0 ? 1 : 0;
    }
  }
  TEST_COMPARE(sloping, >, 100);
}

TEUCHOS_UNIT_TEST(Tangential, scalingScalesTheBound) {
  std::mt19937 random(44);
  const Problem problem = coulombProblem(random);
  const Vector pressures = somePressures(problem, random);
  for (const Tangential& t : problem.tangentials) {
    TEST_COMPARE(std::abs(t.scaled(3).bound(pressures) - 3 * t.bound(pressures)), <,
                 1e-14);
    TEST_EQUALITY(t.scaled(0).bound(pressures), 0.0);
  }
}

}  // namespace

}  // namespace epafi
