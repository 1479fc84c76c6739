#pragma once

#include "bem/base/Matrix.hpp"

#include <memory>

namespace epafi::bem {

/// A half-open range of rows.
struct Rows {
  Index begin = 0;
  Index end = 0;
  Index size() const { return end - begin; }
  bool contain(Index i) const { return begin <= i && i < end; }
};

/// The factor L of a symmetric positive definite matrix A = L Lᵀ, wherever its pieces
/// live.
class CholeskyFactor {
 public:
  virtual ~CholeskyFactor() = default;

  /// A⁻¹ b for a replicated vector b.
  virtual Vector solve(const Vector& b) const = 0;

  /// L⁻¹ B for an n x m matrix B, given and returned by my rows of n.
  virtual Matrix forward(Matrix rows) const = 0;

  /// L⁻ᵀ b for a replicated vector b.
  virtual Vector backward(const Vector& b) const = 0;

  /// The last `count` rows and columns of L⁻¹; empty where L is on several processes.
  virtual Matrix inverseOfLast(Index) const { return {}; }
};

/// The one door to dense linear algebra on matrices distributed by rows.
///
/// A matrix with n rows is held as the rows myRows(n) of this process, all columns;
/// vectors are replicated.  A symmetric matrix is given by its lower triangle: what
/// stands above the diagonal is neither read nor kept.  All calls are collective.
/// [doc/architecture.md]
class DenseAlgebra {
 public:
  virtual ~DenseAlgebra() = default;

  virtual Rows myRows(Index n) const = 0;

  /// \throws NumericalError if the matrix is not positive definite.  `name` is for the
  /// message.
  virtual std::unique_ptr<CholeskyFactor> cholesky(Matrix lower,
                                                   const char* name) const = 0;

  /// C + Yᵀ Y, the lower triangle of a symmetric matrix; Y has n rows (mine are given), C
  /// as many as Y has columns.
  virtual Matrix addGram(Matrix lower, const Matrix& y) const = 0;

  /// C + scale X Xᵀ, the lower triangle; X has as many rows as C (mine are given).
  virtual Matrix addOuter(Matrix lower, const Matrix& x, double scale) const = 0;

  /// C + Xᵀ Y, by my rows of the result; X (n x k) and Y (n x m) by my rows of n.
  virtual Matrix addTransposeTimes(Matrix c, const Matrix& x, const Matrix& y) const = 0;

  /// A x for a replicated vector; A is n x m by my rows of n, the result is replicated.
  virtual Vector multiply(const Matrix& a, Index n, const Vector& x) const = 0;

  /// A x for a symmetric matrix of which only the lower triangle is given.
  virtual Vector multiplySymmetric(const Matrix& lower, const Vector& x) const = 0;

  /// The whole matrix on every process; for small ones only.  A is n x m by my rows.
  virtual Matrix replicate(Matrix rows, Index n) const = 0;

  /// The sum over all processes, in place of each one's own.
  virtual Vector sum(Vector mine) const = 0;

  /// What rank 0 has, also where others have more or fewer numbers.
  virtual Vector broadcast(Vector root) const = 0;

  virtual int rank() const = 0;
  virtual int processes() const = 0;
};

}  // namespace epafi::bem
