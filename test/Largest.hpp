#pragma once

#include "bem/base/Matrix.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::test {

/// Entries by size; NaN if one of them is.
class Largest {
 public:
  void take(double x) {
    if (!std::isnan(size_) && !(std::abs(x) <= size_))
      size_ = std::abs(x);
  }
  double size() const { return size_; }

 private:
  double size_ = 0;
};

inline double largest(const bem::Vector& v) {
  Largest size;
  for (const double x : v)
    size.take(x);
  return size.size();
}

inline double largest(const bem::Matrix& m) {
  Largest size;
  for (bem::Index j = 0; j < m.columns(); ++j)
    for (bem::Index i = 0; i < m.rows(); ++i)
      size.take(m(i, j));
  return size.size();
}

/// Of entry by entry; vectors of different lengths differ by 1 at least.
inline double largestDifference(const bem::Vector& a, const bem::Vector& b) {
  Largest size;
  size.take(a.size() == b.size() ? 0 : 1);
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    size.take(a[i] - b[i]);
  return size.size();
}

inline double largestDifference(const bem::Matrix& a, const bem::Matrix& b) {
  const bool alike = a.rows() == b.rows() && a.columns() == b.columns();
  Largest size;
  size.take(alike ? 0 : 1);
  for (bem::Index j = 0; alike && j < a.columns(); ++j)
    for (bem::Index i = 0; i < a.rows(); ++i)
      size.take(a(i, j) - b(i, j));
  return size.size();
}

/// The largest difference over the largest entry of b.
template <class Numbers>
double relativeDifference(const Numbers& a, const Numbers& b) {
  return largestDifference(a, b) / largest(b);
}

}  // namespace epafi::test
