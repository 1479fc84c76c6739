#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::bem {

// Dense algebra of the size of a body's boundary, by LAPACK and BLAS with as many threads as
// pay.  A symmetric matrix is given by its lower triangle: what stands above the diagonal is
// neither read nor kept.

/// The factor L of a symmetric positive definite matrix A = L Lᵀ, in LAPACK's rectangular full
/// packed form: half the memory of a square, and BLAS runs on its three parts as fast as on
/// the whole.
class CholeskyFactor {
 public:
  /// \throws NumericalError if the matrix is not positive definite.  `name` is for the
  /// message.
  CholeskyFactor(Matrix lower, const char* name);

  /// A⁻¹ b
  Vector solve(const Vector& b) const;
  /// L⁻¹ B
  Matrix forward(Matrix b) const;
  /// L⁻ᵀ b
  Vector backward(const Vector& b) const;
  /// The last `count` rows and columns of L⁻¹.
  Matrix inverseOfLast(Index count) const;

 private:
  double entry(Index i, Index j) const;
  void triangularSolve(const char* transposed, int columns, double* b, int ld) const;

  int rows_;
  Matrix packed_;
};

/// C + Yᵀ Y, the lower triangle of a symmetric matrix.
Matrix addGram(Matrix lower, const Matrix& y);

/// C + scale X Xᵀ, the lower triangle.
Matrix addOuter(Matrix lower, const Matrix& x, double scale);

/// C + Xᵀ Y
Matrix addTransposeTimes(Matrix c, const Matrix& x, const Matrix& y);

/// A x
Vector multiply(const Matrix& a, const Vector& x);

/// A x of a symmetric matrix.
Vector multiplySymmetric(const Matrix& lower, const Vector& x);

}  // namespace epafi::bem
