#include "bem/algebra/LeastSquares.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <cmath>

namespace {

namespace bem = epafi::bem;
using bem::Vector;

Vector column(double frequency) {
  Vector result;
  for (int i = 0; i < 40; ++i)
    result.push_back(std::sin(1 + frequency * i));
  return result;
}

/// What is left is normal to all columns, and as long as it is said to be.
TEUCHOS_UNIT_TEST(LeastSquares, leaveWhatNoColumnHas) {
  const std::vector<Vector> columns = {column(0.3), bem::times(1e-3, column(0.7)),
                                       column(2)};
  const Vector b = column(1.1);
  const bem::LeastSquares solved = bem::leastSquares(columns, b, 1e-12);
  TEST_EQUALITY(solved.rank, 3);
  Vector rest = b;
  for (std::size_t k = 0; k < columns.size(); ++k)
    bem::axpy(-solved.x[k], columns[k], rest);
  for (const Vector& one : columns)
    TEST_COMPARE(std::abs(bem::dot(one, rest)), <, 1e-14 * bem::dot(b, b));
  TEST_FLOATING_EQUALITY(solved.rest, std::sqrt(bem::dot(rest, rest)), 1e-13);
  TEST_COMPARE(solved.rest, >, 1);
}

/// Of columns that depend on each other the largest is taken, and those of zeros are not; there may
/// be more columns than rows, or none.
TEUCHOS_UNIT_TEST(LeastSquares, takeIndependentColumnsAlone) {
  const Vector one = column(0.3);
  const bem::LeastSquares solved = bem::leastSquares(
      {bem::times(0.5, one), one, Vector(one.size())}, bem::times(3, one), 1e-10);
  TEST_EQUALITY(solved.rank, 1);
  TEST_EQUALITY(solved.x[0], 0);
  TEST_FLOATING_EQUALITY(solved.x[1], 3.0, 1e-14);
  TEST_EQUALITY(solved.x[2], 0);
  TEST_COMPARE(solved.rest, <, 1e-13);
  const bem::LeastSquares wide =
      bem::leastSquares({{1, 0}, {1, 2}, {0, 1}}, {3, 4}, 1e-10);
  TEST_EQUALITY(wide.rank, 2);
  TEST_COMPARE(wide.rest, <, 1e-15);
  TEST_FLOATING_EQUALITY(wide.x[0] + wide.x[1], 3.0, 1e-14);
  TEST_FLOATING_EQUALITY(2 * wide.x[1] + wide.x[2], 4.0, 1e-14);
  TEST_FLOATING_EQUALITY(
      bem::leastSquares(std::vector<bem::Vector>(), {3, 4}, 1e-10).rest, 5.0, 1e-15);
}

}  // namespace
