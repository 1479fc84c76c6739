#pragma once

#include "bem/operators/SingleLayerSolver.hpp"
#include "bem/tpetra/BelosOptions.hpp"
#include "bem/tpetra/TpetraAlgebra.hpp"

namespace epafi::bem {

/// V⁻¹ by Belos' conjugate gradients on the distributed rows, preconditioned by the
/// inverse of every process's own diagonal block.  On one process that block is V, and
/// one step solves; the more processes, the more steps.
class BelosSolver final : public SingleLayerSolver {
 public:
  BelosSolver(const TpetraAlgebra& algebra, const BelosOptions& options)
      : algebra_(algebra), options_(options) {}

  Matrix solve(Matrix lower, const Matrix& right) const override;

 private:
  const TpetraAlgebra& algebra_;
  BelosOptions options_;
};

}  // namespace epafi::bem
