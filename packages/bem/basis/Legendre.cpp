#include "bem/basis/Legendre.hpp"

#include <array>
#include <cmath>

namespace epafi::bem {

double DisplacementBasis::slope(int k) {
  static const std::array<double, largestDegree + 1> slopes = [] {
    std::array<double, largestDegree + 1> table{-0.5, 0.5};
    for (std::size_t i = 2; i < table.size(); ++i)
      table[i] = std::sqrt((2 * static_cast<double>(i) - 1) / 2);
    return table;
  }();
  return slopes[k];
}

void DisplacementBasis::values(int degree, double t, double* values) {
  std::array<double, largestDegree + 2> legendre{};
  legendreValues(degree, t, legendre.data());
  values[0] = 0.5 * (1 - t);
  values[1] = 0.5 * (1 + t);
  for (int k = 2; k <= degree; ++k)
    values[k] = slope(k) / (2 * k - 1) * (legendre[k] - legendre[k - 2]);
}

Matrix DisplacementBasis::legendreCoefficients(int degree) {
  Matrix c(degree + 1, degree + 1);
  c(0, 0) = 0.5;
  c(1, 0) = -0.5;
  c(0, 1) = 0.5;
  c(1, 1) = 0.5;
  for (int k = 2; k <= degree; ++k) {
    c(k, k) = slope(k) / (2 * k - 1);
    c(k - 2, k) = -c(k, k);
  }
  return c;
}

}  // namespace epafi::bem
