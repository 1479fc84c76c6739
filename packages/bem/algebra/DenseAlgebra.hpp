#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::bem {

// Symmetric matrices of a body, by LAPACK and BLAS with blasThreadsFor() threads (products of others:
// Products; of a contact boundary: SmallAlgebra).  A symmetric matrix is given by its lower triangle; entries above the diagonal are neither read
// nor preserved.

/// The factor L of a symmetric positive definite matrix A = L Lᵀ, in LAPACK's rectangular full
/// packed form: half the memory of a square matrix, and BLAS 3 is as fast on its three parts
/// as on the whole.
class CholeskyFactor {
 public:
  /// \param name of the matrix, for the message
  /// \throws NumericalError if the matrix is not positive definite
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

/// A x of a symmetric matrix.
Vector multiplySymmetric(const Matrix& lower, const Vector& x);

}  // namespace epafi::bem
