#include "bem/algebra/DoubledSums.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <random>

// Sums of two doubles against 113 binary digits.
namespace epafi::bem {
namespace {

__extension__ using Quadruple = __float128;

struct Numbers {
  explicit Numbers(std::size_t size) : a(size), x(size) {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (std::size_t i = 0; i < size; ++i) {
      a[i] = uniform(generator);
      x[i] = uniform(generator) + 1e-17L * uniform(generator);
    }
  }
  Vector a;
  std::vector<long double> x;
};

TEUCHOS_UNIT_TEST(DoubledSums, keepTwiceTheDigitsWhereTermsCancel) {
  for (const std::size_t half : {1, 4, 7, 8, 9, 37}) {
    // all terms twice with opposite signs, but for 1e-22 in one of them
    Numbers numbers(half);
    numbers.a.resize(2 * half);
    numbers.x.resize(2 * half);
    for (std::size_t i = 0; i < half; ++i) {
      numbers.a[half + i] = -numbers.a[i];
      numbers.x[half + i] = numbers.x[i];
    }
    Doubled x(numbers.x);
    x.low[0] += 1e-22;
    Quadruple sum = 0;
    for (std::size_t i = 0; i < 2 * half; ++i)
      sum += Quadruple(numbers.a[i]) * (Quadruple(x.high[i]) + x.low[i]);
    const long double found =
        dotDoubled(numbers.a.data(), static_cast<Index>(2 * half), x, 0);
    TEST_COMPARE(std::abs(static_cast<double>(sum)), >, 1e-24);
    TEST_COMPARE(std::abs(static_cast<double>(found - sum)), <, 1e-29);
  }
}

TEUCHOS_UNIT_TEST(DoubledSums, addMultiplesBehindAPlaceAlone) {
  constexpr std::size_t size = 21;
  const Numbers numbers(size);
  Doubled y(size + 3);
  std::vector<Quadruple> expected(size + 3);
  for (const long double factor : {1.0L / 3, -1e3L, 1e3L - 1.0L / 3, 1e-21L}) {
    addDoubled(factor, numbers.a.data(), size, y, 2);
    for (std::size_t i = 0; i < size; ++i)
      expected[i + 2] += Quadruple(factor) * numbers.a[i];
  }
  for (std::size_t i = 0; i < size + 3; ++i)
    TEST_COMPARE(
        std::abs(static_cast<double>(Quadruple(y.high[i]) + y.low[i] - expected[i])), <,
        1e-27);
}

}  // namespace
}  // namespace epafi::bem
