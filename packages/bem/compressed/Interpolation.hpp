#pragma once

#include "bem/base/Matrix.hpp"

#include <vector>

namespace epafi::bem {

/// All columns of a matrix by some of them:  A ≈ A_S T,  T the identity on S.
struct Interpolation {
  std::vector<Index> skeleton;  ///< S
  Matrix weights;               ///< T, skeleton x columns
};

/// By pivoted QR: what is left of each column outside the span of the skeleton is smaller
/// than the threshold, an absolute one.
Interpolation interpolateColumns(Matrix a, double threshold);

}  // namespace epafi::bem
