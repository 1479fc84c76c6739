#include "contact/equation/Complementarity.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace epafi::contact {

namespace {

struct Function {
  bool meritIsSmooth;
  Complementarity (*normal)(double multiplier, double penetration);
  Complementarity (*tangential)(double multiplier, double slip, double bound);
};

constexpr Function functions[] = {{false, projectedNormal, projectedTangential},
                                  {true, fischerNormal, fischerTangential}};

TEUCHOS_UNIT_TEST(Complementarity, normalVanishesExactlyOnSignorinisGraph) {
  for (const auto& f : functions) {
    for (double a : {0.0, 1e-9, 0.3, 7.0}) {
      TEST_COMPARE(std::abs(f.normal(a, 0).value), <, 1e-15);
      TEST_COMPARE(std::abs(f.normal(0, -a).value), <, 1e-15);
    }
    for (double a : {0.1, 2.0}) {
      TEST_COMPARE(std::abs(f.normal(-a, 0).value), >, 0.05);  // tension
      TEST_COMPARE(std::abs(f.normal(0, a).value), >, 0.05);   // penetration
      TEST_COMPARE(std::abs(f.normal(a, -a).value), >, 0.05);  // pressure across a gap
    }
  }
}

TEUCHOS_UNIT_TEST(Complementarity, tangentialVanishesExactlyOnTrescasGraph) {
  for (const auto& f : functions)
    for (double s : {0.0, 0.5, 2.0}) {
      for (double a : {0.0, 0.3, 9.0}) {
        TEST_COMPARE(std::abs(f.tangential(s, a, s).value), <, 1e-15);
        TEST_COMPARE(std::abs(f.tangential(-s, -a, s).value), <, 1e-15);
      }
      TEST_COMPARE(std::abs(f.tangential(0.5 * s, 0, s).value), <, 1e-15);
      for (double a : {0.1, 2.0}) {
        TEST_COMPARE(std::abs(f.tangential(s + a, 0, s).value), >, 0.02);
        TEST_COMPARE(std::abs(f.tangential(-s - a, 0, s).value), >, 0.02);
        if (s > 0) {
          TEST_COMPARE(std::abs(f.tangential(s, -a, s).value), >, 0.02);
          TEST_COMPARE(std::abs(f.tangential(-s, a, s).value), >, 0.02);
          TEST_COMPARE(std::abs(f.tangential(0, a, s).value), >, 0.02);
        }
      }
    }
}

/// Across every kink the slope of F² jumps for the projection and does not for the merit's function.
TEUCHOS_UNIT_TEST(Complementarity, onlyTheMeritsSquareIsSmooth) {
  for (const auto& f : functions) {
    double jump = 0;
    const double h = 1e-7;
    const auto look = [&](double multiplier, double y, double s) {
      // Both sides of a kink at (multiplier, y), in many directions.
      for (int k = 0; k < 16; ++k) {
        const double a = h * std::cos(0.39 * k);
        const double b = h * std::sin(0.39 * k);
        const auto up = f.tangential(multiplier + a, y + b, s);
        const auto down = f.tangential(multiplier - a, y - b, s);
        jump = std::max(
            {jump, std::abs(up.value * up.multiplier - down.value * down.multiplier),
             std::abs(up.value * up.penetration - down.value * down.penetration)});
        const auto right = f.normal(multiplier + a, y + b);
        const auto left = f.normal(multiplier - a, y - b);
        jump = std::max(jump, std::abs(right.value * right.multiplier -
                                       left.value * left.multiplier));
      }
    };
    for (double s : {0.0, 1.0})
      for (int k = -8; k <= 8; ++k) {
        const double x = 0.25 * k;
        look(x, s - x, s);
        look(x, -s - x, s);
        look(s, x, s);
        look(-s, x, s);
        look(x, 0, s);
        look(x, -x, s);
      }
    if (f.meritIsSmooth)
      TEST_COMPARE(jump, <, 1e-5);
    if (!f.meritIsSmooth)
      TEST_COMPARE(jump, >, 0.1);
  }
}

/// What keeps Newton's matrix definite: F grows with λ and falls with y, never both flat.
TEUCHOS_UNIT_TEST(Complementarity, slopesHaveTheirSignsAndNeverVanishTogether) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-2, 2);
  for (const auto& f : functions)
    for (int k = 0; k < 5000; ++k) {
      // Kinks included.
      const double s = k % 3 == 0 ? 0.0 : 1.0;
      const double multiplier = k % 7 == 0 ? s : number(random);
      const double y = k % 4 == 0 ? 0.0 : (k % 11 == 0 ? s - multiplier : number(random));
      for (const auto& row : {f.normal(multiplier, y), f.tangential(multiplier, y, s)}) {
        TEST_COMPARE(row.multiplier, >=, 0.0);
        TEST_COMPARE(row.penetration, <=, 0.0);
        TEST_COMPARE(row.multiplier - row.penetration, >, 0.1);
      }
    }
}

}  // namespace

}  // namespace epafi::contact
