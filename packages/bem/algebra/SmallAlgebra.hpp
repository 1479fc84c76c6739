#pragma once

#include "bem/base/MatrixView.hpp"

namespace epafi::bem {

// Dense algebra for matrices of a contact boundary or of three rigid motions, on one rank.
// For matrices of a body see bem/algebra/DenseAlgebra.

double dot(const Vector& a, const Vector& b);

/// max |x_i|, or NaN if there is one
double largestEntry(const Vector& x);

/// y += s x
void axpy(double s, const Vector& x, Vector& y);

/// s x
Vector times(double s, Vector x);

Vector columnOf(const Matrix& a, Index j);

/// Replaces the lower triangle of a symmetric A by its Cholesky factor L.  Returns 0, or the order
/// of the first leading minor that is not positive.
[[nodiscard]] int cholesky(Matrix& a);

/// B := (L Lᵀ)⁻¹ B
void choleskySolve(const Matrix& factor, MatrixView b);

/// Replaces the upper triangle of A by R of A P = Q R, |diagonal| decreasing.  Returns for each
/// column of R the column of A.
std::vector<Index> pivotedTriangle(Matrix& a);

/// A = U diag(s) Vᵀ; V whole, so that its last columns span the kernel.
struct Svd {
  Matrix u;   ///< rows x min(rows, columns)
  Vector s;   ///< min(rows, columns), descending
  Matrix vt;  ///< columns x columns
};
/// \throws NumericalError
Svd singularValues(Matrix a);
/// Number of singular values above a threshold.
int rank(const Svd& svd, double threshold);

}  // namespace epafi::bem
