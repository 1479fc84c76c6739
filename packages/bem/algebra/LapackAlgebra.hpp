#pragma once

#include "bem/base/DenseAlgebra.hpp"

namespace epafi::bem {

/// DenseAlgebra on one process: LAPACK and BLAS, threads as BLAS has them.
class LapackAlgebra final : public DenseAlgebra {
 public:
  Rows myRows(Index n) const override { return {0, n}; }
  std::unique_ptr<CholeskyFactor> cholesky(Matrix lower, const char* name) const override;
  Matrix addGram(Matrix lower, const Matrix& y) const override;
  Matrix addOuter(Matrix lower, const Matrix& x, double scale) const override;
  Matrix addTransposeTimes(Matrix c, const Matrix& x, const Matrix& y) const override;
  Vector multiply(const Matrix& a, Index n, const Vector& x) const override;
  Vector multiplySymmetric(const Matrix& lower, const Vector& x) const override;
  Matrix replicate(Matrix rows, Index n) const override;
  Vector sum(Vector mine) const override { return mine; }
  Vector broadcast(Vector root) const override { return root; }
  int rank() const override { return 0; }
  int processes() const override { return 1; }
};

}  // namespace epafi::bem
