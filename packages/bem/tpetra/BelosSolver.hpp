#pragma once

#include "bem/operators/SingleLayerSolver.hpp"
#include "bem/tpetra/BelosOptions.hpp"
#include "bem/tpetra/MpiProcesses.hpp"

namespace epafi::bem {

/// V⁻¹ by Belos' conjugate gradients on distributed vectors, preconditioned by the inverse of
/// the diagonal block of every process's own rows.  On one process that block is V, and one
/// step solves; the more processes, the more steps.
class BelosSolver final : public SingleLayerSolver {
 public:
  BelosSolver(const MpiProcesses& processes, const BelosOptions& options)
      : processes_(processes), options_(options) {}

  Matrix solve(Matrix lower, const Matrix& right) const override;

 private:
  const MpiProcesses& processes_;
  BelosOptions options_;
};

}  // namespace epafi::bem
