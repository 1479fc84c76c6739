#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/kernel/Elasticity.hpp"

namespace epafi::bem {

/// Adds a 2 x 2 block whose xx entry belongs at (row, column).
inline void addBlock(Matrix& matrix, Index row, Index column, const Block& b) {
  double* left = matrix.column(column) + row;
  double* right = left + matrix.stride();
  left[0] += b.xx;
  left[1] += b.yx;
  right[0] += b.xy;
  right[1] += b.yy;
}

}  // namespace epafi::bem
