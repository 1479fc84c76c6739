// Slip bounds that follow several pressures: between their limits times the own pressure,
// with the slopes that differences show.
#include "contact/RandomProblem.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace epafi {

namespace {

using contact::NormalShare;
using contact::Problem;
using contact::Tangential;
using contact::Vector;

Problem coupledProblem(std::mt19937& random) {
  test::Recipe recipe;
  recipe.law = "Coulomb";
  recipe.coupling = 2 + static_cast<int>(random() % 4);
  recipe.normals = 3 * (recipe.coupling + 1);
  return randomProblem(recipe, random);
}

/// Pressures of which some are zero, or negative.
Vector somePressures(const Problem& problem, std::mt19937& random) {
  Vector pressures;
  for (contact::Index i = 0; i < problem.normals; ++i)
    pressures.push_back(std::uniform_real_distribution<double>(-0.3, 1)(random));
  pressures.front() = 0;
  return pressures;
}

double pressureOf(const Vector& pressures, contact::Index i) {
  return std::max(pressures[i], 0.0);
}

TEUCHOS_UNIT_TEST(Tangential, staysBetweenItsLimitsTimesItsPressure) {
  std::mt19937 random(41);
  int coupled = 0;
  int inside = 0;
  for (int k = 0; k < 100; ++k) {
    const Problem problem = coupledProblem(random);
    const Vector pressures = somePressures(problem, random);
    for (const Tangential& t : problem.tangentials) {
      if (!t.followsSeveral())
        continue;
      const double own = pressureOf(pressures, t.normal());
      const double bound = t.bound(pressures);
      TEST_COMPARE(bound, >=, 0);
      TEST_COMPARE(bound, <=, t.steepest() * own * (1 + 1e-15));
      coupled += 1;
      inside += t.slopes(pressures).size() > 1 ? 1 : 0;
    }
  }
  TEST_COMPARE(coupled, >, 200);
  TEST_COMPARE(inside, >, 100);
}

TEUCHOS_UNIT_TEST(Tangential, slopesAreTheDerivativeAwayFromKinks) {
  std::mt19937 random(42);
  const double h = 1e-7;
  int several = 0;
  for (int k = 0; k < 100; ++k) {
    const Problem problem = coupledProblem(random);
    Vector pressures = somePressures(problem, random);
    pressures.front() = 0.2;
    Vector more = pressures;
    Vector less = pressures;
    Vector direction;
    for (std::size_t i = 0; i < pressures.size(); ++i) {
      direction.push_back(std::uniform_real_distribution<double>(-1, 1)(random));
      more[i] += h * direction[i];
      less[i] -= h * direction[i];
    }
    for (const Tangential& t : problem.tangentials) {
      double slope = 0;
      for (const NormalShare& s : t.slopes(pressures))
        slope += s.value * direction[s.normal];
      several += t.slopes(pressures).size() > 1 ? 1 : 0;
      TEST_COMPARE(std::abs((t.bound(more) - t.bound(less)) / (2 * h) - slope), <, 1e-6);
    }
  }
  TEST_COMPARE(several, >, 100);
}

TEUCHOS_UNIT_TEST(Tangential, scalingScalesTheBound) {
  std::mt19937 random(44);
  const Problem problem = coupledProblem(random);
  const Vector pressures = somePressures(problem, random);
  for (const Tangential& t : problem.tangentials) {
    TEST_COMPARE(std::abs(t.scaled(3).bound(pressures) - 3 * t.bound(pressures)), <,
                 1e-14);
    TEST_EQUALITY(t.scaled(0).bound(pressures), 0.0);
  }
}

}  // namespace

}  // namespace epafi
