#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::bem {

// Dense algebra of the size of a contact boundary or of three rigid motions, on one rank.
// What grows with the body is bem/algebra/DenseAlgebra's.

double dot(const Vector& a, const Vector& b);

/// y += s x
void axpy(double s, const Vector& x, Vector& y);

Vector columnOf(const Matrix& a, Index j);

Matrix multiply(const Matrix& a, const Matrix& b);

/// Aᵀ B
Matrix transposedTimes(const Matrix& a, const Matrix& b);

/// Replaces the lower triangle of a symmetric A by its factor L.  Returns 0, or the first
/// leading minor that is not positive, counted from 1.
[[nodiscard]] int cholesky(Matrix& a);

/// b := (L Lᵀ)⁻¹ b, of a vector or of columns
void choleskySolve(const Matrix& factor, double* b);
void choleskySolve(const Matrix& factor, double* b, Index columns, Index stride);

/// Replaces A by R in its upper triangle, A P = Q R, diagonal entries falling.  Returns which
/// column of A each of R's was.
std::vector<Index> pivotedTriangle(Matrix& a);

/// A vector as a matrix.
Matrix asColumn(const Vector& v);

}  // namespace epafi::bem
