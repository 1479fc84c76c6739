#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::bem {

/// A symmetric n x n matrix in packed storage of its lower triangle: rows j ... n - 1 of column
/// j, one column after the other.
class LowerTriangle {
 public:
  LowerTriangle() = default;

  /// Packs `lower` in place and releases the rest of its memory.  Entries above the diagonal
  /// are not read.
  explicit LowerTriangle(Matrix lower);

  Index size() const { return size_; }
  /// Entries (j, j) ... (n - 1, j).
  const double* column(Index j) const { return packed_.data() + start(j); }

  /// Full columns of A, one after the other.
  Vector columns(const std::vector<Index>& which) const;

  /// A x
  Vector times(const Vector& x) const;

 private:
  Index start(Index j) const { return j * size_ - j * (j - 1) / 2; }

  Index size_ = 0;
  Matrix packed_;
};

}  // namespace epafi::bem
