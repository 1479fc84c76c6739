#pragma once

#include "bem/base/Matrix.hpp"

namespace epafi::contact {

// Dense algebra of the size of a contact boundary or of three rigid motions, on one rank.
// What grows with the body is bem::DenseAlgebra's.

inline std::size_t at(bem::Index i) { return static_cast<std::size_t>(i); }

double dot(const bem::Vector& a, const bem::Vector& b);

/// y += s x
void axpy(double s, const bem::Vector& x, bem::Vector& y);

bem::Vector columnOf(const bem::Matrix& a, bem::Index j);

bem::Matrix multiply(const bem::Matrix& a, const bem::Matrix& b);

/// Aᵀ B
bem::Matrix transposedTimes(const bem::Matrix& a, const bem::Matrix& b);

/// Replaces the lower triangle of a symmetric A by its factor L.  Returns 0, or the first
/// leading minor that is not positive, counted from 1.
[[nodiscard]] int cholesky(bem::Matrix& a);

/// b := (L Lᵀ)⁻¹ b
void choleskySolve(const bem::Matrix& factor, double* b);

}  // namespace epafi::contact
