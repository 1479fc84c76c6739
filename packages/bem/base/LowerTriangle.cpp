#include "bem/base/LowerTriangle.hpp"

#include <algorithm>
#include <cstring>

namespace epafi::bem {

LowerTriangle::LowerTriangle(Matrix lower)
    : size_(lower.columns()), packed_(std::move(lower)) {
  // never ahead of what is still to be read, since columns only move forward
  for (Index j = 0; j < size_; ++j)
    std::memmove(packed_.data() + start(j), packed_.column(j) + j,
                 at(size_ - j) * sizeof(double));
  packed_.shrink((start(size_) + packed_.stride() - 1) / packed_.stride());
}

Vector LowerTriangle::columns(const std::vector<Index>& which) const {
  Vector result(at(size_) * which.size());
  double* entries = result.data();
  for (const Index c : which) {
    std::copy_n(column(c), size_ - c, entries + c);
    entries += size_;
  }
  // what stands before the diagonal in their rows: column by column of the triangle
  for (Index j = 0; j < size_; ++j)
    for (std::size_t k = 0; k < which.size(); ++k)
      if (j < which[k])
        result[k * at(size_) + at(j)] = column(j)[which[k] - j];
  return result;
}

Vector LowerTriangle::times(const Vector& x) const {
  Vector y(at(size_));
  for (Index j = 0; j < size_; ++j) {
    const double* a = column(j);
    const double xj = x[at(j)];
    double sum = a[0] * xj;
    const double* below = x.data() + j;
    double* mine = y.data() + j;
#pragma omp simd reduction(+ : sum)
    for (Index i = 1; i < size_ - j; ++i) {
      sum += a[i] * below[i];
      mine[i] += a[i] * xj;
    }
    y[at(j)] += sum;
  }
  return y;
}

}  // namespace epafi::bem
