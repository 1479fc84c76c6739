#include "bem/base/LowerTriangle.hpp"

#include <cstring>

namespace epafi::bem {

LowerTriangle::LowerTriangle(Matrix lower, const Rows& mine)
    : size_(lower.columns()), rows_(mine), packed_(std::move(lower)) {
  // never ahead of what is still to be read, since columns only move forward
  for (Index j = 0; j < rows_.end; ++j)
    std::memmove(packed_.data() + start(j), packed_.column(j) + firstRow(j) - rows_.begin,
                 static_cast<std::size_t>(rows_.end - firstRow(j)) * sizeof(double));
  packed_.shrink((start(rows_.end) + packed_.stride() - 1) / packed_.stride());
}

Matrix LowerTriangle::unpacked() const {
  Matrix lower(rows_.size(), size_);
  for (Index j = 0; j < rows_.end; ++j)
    std::copy_n(column(j), rows_.end - firstRow(j),
                lower.column(j) + firstRow(j) - rows_.begin);
  return lower;
}

Vector LowerTriangle::columns(const std::vector<Index>& which) const {
  Vector result(at(size_) * which.size());
  double* entries = result.data();
  for (const Index c : which) {
    for (Index i = firstRow(c); i < rows_.end; ++i)
      entries[i] = column(c)[i - firstRow(c)];
    entries += size_;
  }
  // what stands before the diagonal in their rows: column by column of the triangle
  for (Index j = 0; j < rows_.end; ++j)
    for (std::size_t k = 0; k < which.size(); ++k)
      if (j < which[k] && rows_.contain(which[k]))
        result[k * at(size_) + at(j)] = column(j)[which[k] - firstRow(j)];
  return result;
}

Vector LowerTriangle::times(const Vector& x) const {
  Vector y(size_);
  for (Index j = 0; j < rows_.end; ++j) {
    const double* a = column(j);
    Index first = firstRow(j);
    const double xj = x[j];
    double sum = first == j ? *a++ * xj : 0;
    first += first == j ? 1 : 0;
    const double* below = x.data() + first;
    double* mine = y.data() + first;
    const Index count = rows_.end - first;
#pragma omp simd reduction(+ : sum)
    for (Index i = 0; i < count; ++i) {
      sum += a[i] * below[i];
      mine[i] += a[i] * xj;
    }
    y[j] += sum;
  }
  return y;
}

}  // namespace epafi::bem
