#pragma once

#include "bem/base/DenseAlgebra.hpp"
#include "bem/kernel/Elasticity.hpp"

namespace epafi::bem {

/// Adds a block to the rows that are mine.  Both entries of a column lie side by side.
inline void addBlock(Matrix& matrix, const Rows& mine, Index row, Index column,
                     const Block& b) {
  const Index local = row - mine.begin;
  if (mine.contain(row) && mine.contain(row + 1)) {
    double* left = matrix.column(column) + local;
    double* right = left + matrix.stride();
    left[0] += b.xx;
    left[1] += b.yx;
    right[0] += b.xy;
    right[1] += b.yy;
  } else if (mine.contain(row)) {
    matrix(local, column) += b.xx;
    matrix(local, column + 1) += b.xy;
  } else if (mine.contain(row + 1)) {
    matrix(local + 1, column) += b.yx;
    matrix(local + 1, column + 1) += b.yy;
  }
}

}  // namespace epafi::bem
