#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::bem {

/// Numbers of twice as many digits, each the sum of two doubles.
struct Doubled {
  explicit Doubled(std::size_t size) : high(size), low(size) {}
  explicit Doubled(const std::vector<long double>& numbers);
  std::vector<long double> joined() const;

  Vector high;
  Vector low;
};

/// Σ a_i x_{first + i} over `size` numbers, rounded as if by twice a double's digits.
long double dotDoubled(const double* a, Index size, const Doubled& x, Index first);

/// y_{first + i} += factor a_i likewise.
void addDoubled(long double factor, const double* a, Index size, Doubled& y, Index first);

}  // namespace epafi::bem
