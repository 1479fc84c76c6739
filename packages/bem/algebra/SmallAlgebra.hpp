#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::bem {

// Dense algebra of the size of a contact boundary or of three rigid motions, on one rank.
// What grows with the body is bem::DenseAlgebra's.

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

/// b := (L Lᵀ)⁻¹ b
void choleskySolve(const Matrix& factor, double* b);

}  // namespace epafi::bem
