// Slip bounds as coefficients: of full order where they are smooth, within their hull where they
// jump.
#include "contact/multiplier/MultiplierBasis.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi {

namespace {

using bem::Vector;

const contact::MultiplierBasis& bernstein() {
  return contact::multiplierBasis("Bernstein");
}

double valueAt(const Vector& coefficients, double t) {
  const Vector chi = bernstein().values(static_cast<int>(coefficients.size()) - 1, t);
  return std::inner_product(chi.begin(), chi.end(), coefficients.begin(), 0.0);
}

double smooth(double x) { return 2 + std::sin(3 * x); }

/// Largest error on an element of length 2 h around 0.3.
double errorOn(int degree, double h) {
  const auto bound = [h](double t) { return smooth(0.3 + h * t); };
  const Vector coefficients = contact::boundCoefficients(bernstein(), degree, bound);
  double largest = 0;
  for (int k = -64; k <= 64; ++k) {
    const double t = k / 64.0;
    largest = std::max(largest, std::abs(valueAt(coefficients, t) - bound(t)));
  }
  return largest;
}

TEUCHOS_UNIT_TEST(BoundCoefficients, smoothBoundsAreMetToFullOrder) {
  for (const int q : {1, 2, 3, 4, 5})
    TEST_COMPARE(std::log2(errorOn(q, 0.1) / errorOn(q, 0.05)), >, q + 0.8);
  TEST_COMPARE(errorOn(14, 0.3), <, 1e-13);
}

TEUCHOS_UNIT_TEST(BoundCoefficients, polynomialsOfTheDegreeAreTheirOwnBound) {
  for (const int q : {2, 3, 7}) {
    const auto bound = [q](double t) { return 3 + 0.01 * std::cos(q * std::acos(t)); };
    const Vector coefficients = contact::boundCoefficients(bernstein(), q, bound);
    for (int k = -8; k <= 8; ++k) {
      const double t = k / 8.0;
      TEST_COMPARE(std::abs(valueAt(coefficients, t) - bound(t)), <, 1e-12);
    }
  }
}

TEUCHOS_UNIT_TEST(BoundCoefficients, jumpsAreNeitherOvershotNorUndershot) {
  for (int q = 1; q <= 12; ++q)
    for (int k = 0; k < 45; ++k) {
      const double place = -0.99 + 0.045 * k;
      const auto bound = [place](double t) { return t < place ? 0.5 : 2.0; };
      const Vector coefficients = contact::boundCoefficients(bernstein(), q, bound);
      for (const double coefficient : coefficients) {
        TEST_COMPARE(coefficient, >=, 0.5);
        TEST_COMPARE(coefficient, <=, 2.0);
      }
    }
}

TEUCHOS_UNIT_TEST(BoundCoefficients, areNeverNegative) {
  for (int q = 1; q <= 12; ++q)
    for (int k = -4; k <= 4; ++k) {
      const double zero = k / 4.0;
      const auto touching = [zero](double t) { return (t - zero) * (t - zero); };
      const auto beyond = [zero](double t) { return std::max(0.0, t - zero); };
      for (const double c : contact::boundCoefficients(bernstein(), q, touching))
        TEST_COMPARE(c, >=, 0.0);
      for (const double c : contact::boundCoefficients(bernstein(), q, beyond))
        TEST_COMPARE(c, >=, 0.0);
    }
}

TEUCHOS_UNIT_TEST(BoundCoefficients, valuesStayValuesWhereCoefficientsAreValues) {
  for (const char* name : {"Gauss-Legendre-Lagrange", "Gauss-Lobatto-Lagrange"})
    for (const int q : {1, 4}) {
      const auto& basis = contact::multiplierBasis(name);
      const Vector places = basis.places(q);
      const Vector coefficients = contact::boundCoefficients(basis, q, smooth);
      for (std::size_t i = 0; i < places.size(); ++i)
        TEST_EQUALITY(coefficients[i], smooth(places[i]));
    }
}

}  // namespace

}  // namespace epafi
