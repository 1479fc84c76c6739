#include "bem/algebra/DenseAlgebra.hpp"

#include "Largest.hpp"
#include "Message.hpp"
#include "bem/algebra/Products.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <limits>
#include <random>
#include <string>

namespace epafi {

namespace {

using bem::Index;
using bem::Matrix;
using bem::Vector;

constexpr double rounding = 1e-12;
constexpr Index sizes[] = {1, 2, 7, 65, 128};

Matrix randomMatrix(Index n, Index m, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> entry(-1, 1);
  Matrix a(n, m);
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < n; ++i)
      a(i, j) = entry(random);
  return a;
}

Vector randomVector(Index n) {
  const Matrix a = randomMatrix(n, 1, 2);
  return {a.data(), a.data() + n};
}

/// Positive definite, both triangles.
Matrix positiveDefinite(Index n) {
  const Matrix a = randomMatrix(n, n, 1);
  Matrix result = bem::product(a, bem::transposed(a));
  for (Index j = 0; j < n; ++j)
    result(j, j) += 1;
  return result;
}

/// With what nobody may read above the diagonal.
Matrix lowerOf(const Matrix& symmetric) {
  Matrix a = symmetric.copy();
  for (Index j = 0; j < a.columns(); ++j)
    for (Index i = 0; i < j; ++i)
      a(i, j) = std::numeric_limits<double>::quiet_NaN();
  return a;
}

double differenceBelow(const Matrix& lower, const Matrix& whole) {
  double worst = 0;
  for (Index j = 0; j < whole.columns(); ++j)
    for (Index i = j; i < whole.rows(); ++i)
      worst = std::max(worst, std::abs(lower(i, j) - whole(i, j)));
  return worst / test::largest(whole);
}

TEUCHOS_UNIT_TEST(CholeskyFactor, solvesFromTheLowerTriangle) {
  for (const Index n : sizes) {
    const Matrix a = positiveDefinite(n);
    const bem::CholeskyFactor factor(lowerOf(a), "A");
    const Vector b = randomVector(n);
    TEST_COMPARE(test::largestDifference(bem::multiply(a, factor.solve(b)), b), <,
                 rounding * static_cast<double>(n));
    // L⁻ᵀ L⁻¹ is the inverse, and the end of L⁻¹ that of L's end
    Matrix unit(n, n);
    for (Index j = 0; j < n; ++j)
      unit(j, j) = 1;
    const Matrix half = factor.forward(std::move(unit));
    TEST_COMPARE(
        test::largestDifference(factor.backward(bem::multiply(half, b)), factor.solve(b)),
        <, rounding);
    const Index count = (n + 1) / 2;
    const Matrix end = factor.inverseOfLast(count);
    for (Index j = 0; j < count; ++j)
      for (Index i = j; i < count; ++i)
        TEST_COMPARE(std::abs(end(i, j) - half(n - count + i, n - count + j)), <,
                     rounding);
  }
}

TEUCHOS_UNIT_TEST(CholeskyFactor, namesTheRowWhereAMatrixIsIndefinite) {
  for (const Index n : sizes)
    for (const Index row : {Index(0), n / 2, n - 1}) {
      Matrix a = positiveDefinite(n);
      a(row, row) = -1;
      const std::string told = test::messageOf<bem::NumericalError>(
          [&] { bem::CholeskyFactor(std::move(a), "A"); });
      TEST_ASSERT(test::contains(told, "A is not positive definite"));
      TEST_ASSERT(test::contains(told, bem::message("row ", row + 1, " of ", n)));
    }
}

TEUCHOS_UNIT_TEST(DenseAlgebra, multipliesAsWritten) {
  for (const Index n : sizes) {
    const Matrix x = randomMatrix(n, 17, 4);
    const Matrix y = randomMatrix(n, 5, 5);
    const Matrix c = positiveDefinite(17);
    const Matrix d = positiveDefinite(n);
    Matrix gram = c.copy();
    bem::addTransposedProduct(1, x, x, gram);
    TEST_COMPARE(differenceBelow(bem::addGram(lowerOf(c), x), gram), <, rounding);
    Matrix outer = d.copy();
    bem::addProduct(-0.7, x, bem::transposed(x), outer);
    TEST_COMPARE(differenceBelow(bem::addOuter(lowerOf(d), x, -0.7), outer), <, rounding);
    Matrix sum = randomMatrix(17, 5, 6);
    const Matrix mixed = bem::addTransposeTimes(sum.copy(), x, y);
    bem::addTransposedProduct(1, x, y, sum);
    TEST_COMPARE(differenceBelow(mixed, sum), <, rounding);
    const Vector v = randomVector(n);
    TEST_COMPARE(test::largestDifference(bem::multiplySymmetric(lowerOf(d), v),
                                         bem::multiply(d, v)),
                 <, rounding * test::largest(d));
  }
}

}  // namespace

}  // namespace epafi
