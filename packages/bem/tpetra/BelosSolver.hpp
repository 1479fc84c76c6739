#pragma once

#include "bem/operators/SingleLayerSolver.hpp"
#include "bem/tpetra/BelosOptions.hpp"
#include "bem/tpetra/MpiProcesses.hpp"

namespace epafi::bem {

/// Conjugate gradients of Belos for V on distributed vectors.  Block Jacobi preconditioner with
/// one diagonal block of V for each process: a single process needs one step, more processes
/// need more steps.
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
