#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::bem {

/// Another way to V⁻¹ than Cholesky's factors.
class SingleLayerSolver {
 public:
  virtual ~SingleLayerSolver() = default;

  /// V⁻¹ B; V by the lower triangle.  Collective.
  /// \throws NumericalError if V is not positive definite, or if it takes too long.
  virtual Matrix solve(Matrix lower, const Matrix& right) const = 0;
};

}  // namespace epafi::bem
