#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::bem {

/// Numbers with twice the digits of a double, each the sum high + low of two doubles.
struct Doubled {
  explicit Doubled(std::size_t size) : high(size), low(size) {}
  explicit Doubled(const std::vector<long double>& numbers);
  std::vector<long double> joined() const;

  Vector high;
  Vector low;
};

/// Σ a_i x_{first + i}, i = 0 ... size - 1, as accurate as in twice the digits of a double.
long double dotDoubled(const double* a, Index size, const Doubled& x, Index first);

/// y_{first + i} += factor a_i, i = 0 ... size - 1, with the same accuracy.
void addDoubled(long double factor, const double* a, Index size, Doubled& y, Index first);

}  // namespace epafi::bem
