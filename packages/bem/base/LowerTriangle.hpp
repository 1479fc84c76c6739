#pragma once

#include "bem/base/DenseAlgebra.hpp"

#include <algorithm>

namespace epafi::bem {

/// A symmetric n x n matrix in the memory of its lower triangle alone, my rows.
///
/// Column j holds its rows from firstRow(j) to rows().end, one column after the other.
class LowerTriangle {
 public:
  LowerTriangle() = default;

  /// Packs the triangle in its own memory and gives the rest of that back.
  /// `lower`: my rows of the n x n matrix, what stands above the diagonal is not read.
  LowerTriangle(Matrix lower, const Rows& mine);

  Rows rows() const { return rows_; }
  Index firstRow(Index j) const { return std::max(j, rows_.begin); }
  /// The entry (firstRow(j), j) and those below it; j < rows().end.
  const double* column(Index j) const { return packed_.data() + start(j); }

  /// My rows of the n x n matrix, zero above the diagonal; new memory.
  Matrix unpacked() const;

  /// What my rows contribute to columns of A, one after the other; the sum over all
  /// processes is the columns.
  Vector columns(const std::vector<Index>& which) const;

  /// What my rows contribute to A x; the sum over all processes is A x.
  Vector times(const Vector& x) const;

 private:
  /// Columns before rows().begin have all my rows.
  Index start(Index j) const {
    const Index full = std::min(j, rows_.begin);
    const Index shorter = j - full;
    return full * rows_.size() + shorter * rows_.size() - shorter * (shorter - 1) / 2;
  }

  Index size_ = 0;
  Rows rows_;
  Matrix packed_;
};

}  // namespace epafi::bem
