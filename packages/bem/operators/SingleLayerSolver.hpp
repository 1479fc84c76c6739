#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::bem {

/// Solver for the single layer matrix V instead of a dense Cholesky factorization.
class SingleLayerSolver {
 public:
  virtual ~SingleLayerSolver() = default;

  /// V⁻¹ B; `lower` is the lower triangle of V.  Collective.
  /// \throws NumericalError if V is not positive definite or the solver does not converge
  virtual Matrix solve(Matrix lower, const Matrix& right) const = 0;
};

}  // namespace epafi::bem
