#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::bem {

/// A symmetric n x n matrix in the memory of its lower triangle alone: column j holds its rows
/// from j on, one column after the other.
class LowerTriangle {
 public:
  LowerTriangle() = default;

  /// Packs the triangle in its own memory and gives the rest of that back.
  /// `lower`: what stands above the diagonal is not read.
  explicit LowerTriangle(Matrix lower);

  Index size() const { return size_; }
  /// The entry (j, j) and those below it.
  const double* column(Index j) const { return packed_.data() + start(j); }

  /// Columns of A, one after the other.
  Vector columns(const std::vector<Index>& which) const;

  /// A x
  Vector times(const Vector& x) const;

 private:
  Index start(Index j) const { return j * size_ - j * (j - 1) / 2; }

  Index size_ = 0;
  Matrix packed_;
};

}  // namespace epafi::bem
