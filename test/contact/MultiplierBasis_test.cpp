#include "contact/multiplier/MultiplierBasis.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>
#include <numeric>

namespace epafi {

namespace {

constexpr int highestDegree = 25;

TEUCHOS_UNIT_TEST(MultiplierBasis, valuesOfEveryBasisSumToOne) {
  for (const auto& basis : contact::multiplierBases())
    for (int q = 0; q <= highestDegree; ++q)
      for (int k = -16; k <= 16; ++k) {
        const double t = k / 16.0;
        const bem::Vector values = basis.values(q, t);
        TEST_EQUALITY(values.size(), static_cast<std::size_t>(q + 1));
        TEST_COMPARE(std::abs(std::accumulate(values.begin(), values.end(), -1.0)), <,
                     1e-13);
      }
}

/// One at their place and zero at the others.  The interpolant of a polynomial of the same degree
/// is the polynomial: every function has degree q and belongs to its node.
TEUCHOS_UNIT_TEST(MultiplierBasis, lagrangeFunctionsInterpolate) {
  for (const char* name : {"Gauss-Legendre-Lagrange", "Gauss-Lobatto-Lagrange"})
    for (int q = 0; q <= highestDegree; ++q) {
      const auto& basis = contact::multiplierBasis(name);
      const bem::Vector places = basis.places(q);
      for (std::size_t i = 0; i < places.size(); ++i) {
        const bem::Vector values = basis.values(q, places[i]);
        for (std::size_t j = 0; j < values.size(); ++j)
          TEST_EQUALITY(values[j], i == j ? 1.0 : 0.0);
      }
      for (double t : {-0.99, -0.3, 0.1234, 0.77}) {
        const bem::Vector values = basis.values(q, t);
        double sum = 0;
        for (std::size_t i = 0; i < values.size(); ++i)
          sum += values[i] * std::cos(q * std::acos(places[i]));
        TEST_COMPARE(std::abs(sum - std::cos(q * std::acos(t))), <, 1e-12);
      }
    }
}

TEUCHOS_UNIT_TEST(MultiplierBasis, gaussNodesMakeTheRuleExactToDegreeTwoNMinusOne) {
  // The nodal polynomial is orthogonal to all of lower degree exactly for Gauss's points;
  // tested through P_3 and P_5: zeros in closed form.
  const auto& gauss = contact::multiplierBasis("Gauss-Legendre-Lagrange");
  TEST_COMPARE(std::abs(gauss.places(2)[2] - std::sqrt(0.6)), <, 1e-15);
  const double p5 = std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3;
  TEST_COMPARE(std::abs(gauss.places(4)[4] - p5), <, 1e-15);
  const auto& lobatto = contact::multiplierBasis("Gauss-Lobatto-Lagrange");
  TEST_EQUALITY(lobatto.places(1)[0], -1.0);
  TEST_EQUALITY(lobatto.places(2)[1], 0.0);
  TEST_COMPARE(std::abs(lobatto.places(3)[2] - std::sqrt(0.2)), <, 1e-15);
  TEST_COMPARE(std::abs(lobatto.places(4)[3] - std::sqrt(3.0 / 7)), <, 1e-15);
}

TEUCHOS_UNIT_TEST(MultiplierBasis, placesIncreaseAndLieInTheElement) {
  for (const auto& basis : contact::multiplierBases())
    for (int q = 0; q <= highestDegree; ++q) {
      const bem::Vector places = basis.places(q);
      for (std::size_t i = 0; i < places.size(); ++i) {
        TEST_COMPARE(std::abs(places[i]), <=, 1.0);
        if (i > 0)
          TEST_COMPARE(places[i - 1], <, places[i]);
      }
    }
}

TEUCHOS_UNIT_TEST(MultiplierBasis, bernsteinIsNonnegativeAndReproducesItsControlPoints) {
  const auto& bernstein = contact::multiplierBasis("Bernstein");
  for (int q = 1; q <= highestDegree; ++q)
    for (int k = -8; k <= 8; ++k) {
      const double t = k / 8.0;
      const bem::Vector values = bernstein.values(q, t);
      const bem::Vector places = bernstein.places(q);
      double sum = 0;
      for (std::size_t i = 0; i < values.size(); ++i) {
        TEST_COMPARE(values[i], >=, 0.0);
        sum += values[i] * places[i];
      }
      TEST_COMPARE(std::abs(sum - t), <, 1e-14);
    }
}

/// f(t) = Σ_i B_i*(t) ∫ f B_i with the dual functions B* = M⁻¹ B: the largest that |f(t)| can
/// be with |∫ f B_i| <= ∫ B_i is Σ_i |B_i*(t)| ∫ B_i.
TEUCHOS_UNIT_TEST(MultiplierBasis, amplificationIsReachedAtTheEndsAndNowhereExceeded) {
  const auto& bernstein = contact::multiplierBasis("Bernstein");
  for (int q = 0; q <= bernstein.largestDegree; ++q) {
    const bem::Rule& rule = bem::gaussLegendre(q + 1);
    const auto n = static_cast<bem::Index>(q + 1);
    bem::Matrix mass(n, n);
    bem::Vector integrals(n, 0.0);
    for (std::size_t k = 0; k < rule.points.size(); ++k) {
      const bem::Vector b = bernstein.values(q, rule.points[k]);
      for (bem::Index j = 0; j < n; ++j) {
        const double weighted = rule.weights[k] * b[j];
        integrals[j] += weighted;
        for (bem::Index i = 0; i < n; ++i)
          mass(i, j) += weighted * b[i];
      }
    }
    const int definite = bem::cholesky(mass);
    TEST_EQUALITY(definite, 0);
    const double claimed = bernstein.amplification(q);
    for (int k = -16; k <= 16; ++k) {
      bem::Vector dual = bernstein.values(q, k / 16.0);
      bem::choleskySolve(mass, bem::MatrixView(dual));
      double largest = 0;
      for (std::size_t i = 0; i < dual.size(); ++i)
        largest += std::abs(dual[i]) * integrals[i];
      TEST_COMPARE(largest, <=, (1 + 1e-6) * claimed);
      if (std::abs(k) == 16)
        TEST_COMPARE(largest, >=, (1 - 1e-6) * claimed);
    }
  }
}

/// Dual to Lagrange's functions of the displacement, with Gauss-Lobatto's weights, which
/// are positive.
TEUCHOS_UNIT_TEST(MultiplierBasis, biorthogonalIsDualToLagrangeAtLobattosPoints) {
  const auto& dual = contact::multiplierBasis("Biorthogonal");
  const auto& lobatto = contact::multiplierBasis("Gauss-Lobatto-Lagrange");
  for (int q = 0; q <= highestDegree; ++q) {
    const bem::Rule& rule = bem::gaussLegendre(q + 1);
    const std::size_t n = q + 1;
    std::vector<bem::Vector> products(n, bem::Vector(n, 0.0));
    bem::Vector integrals(n, 0.0);
    for (std::size_t k = 0; k < rule.points.size(); ++k) {
      const bem::Vector chi = dual.values(q, rule.points[k]);
      const bem::Vector theta = lobatto.values(q, rule.points[k]);
      for (std::size_t i = 0; i < n; ++i) {
        integrals[i] += rule.weights[k] * theta[i];
        for (std::size_t j = 0; j < n; ++j)
          products[i][j] += rule.weights[k] * chi[i] * theta[j];
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      TEST_COMPARE(integrals[i], >, 0);
      for (std::size_t j = 0; j < n; ++j)
        TEST_COMPARE(std::abs(products[i][j] - (i == j ? integrals[i] : 0.0)), <, 1e-13);
    }
  }
}

}  // namespace

}  // namespace epafi
