#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::bem {

/// x with least |Σ x_k a_k - b|.
struct LeastSquares {
  Vector x;
  Index rank = 0;   ///< number of independent columns; x is zero at the others
  double rest = 0;  ///< |Σ x_k a_k - b|
};

/// By LAPACK's QR with pivoting: the largest column first, then what is largest beside those taken.
/// \param columns    a_k, each as long as b
/// \param dependent  columns whose rest is at most this, over the largest one, depend on others
LeastSquares leastSquares(const std::vector<Vector>& columns, Vector b, double dependent);

/// The same for the columns of B: X, and what each leaves.
struct SeveralLeastSquares {
  Matrix x;
  Index rank = 0;
  Vector rests;
};
SeveralLeastSquares leastSquares(Matrix a, Matrix b, double dependent);

}  // namespace epafi::bem
