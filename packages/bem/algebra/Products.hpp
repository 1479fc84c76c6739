#pragma once

#include "bem/base/MatrixView.hpp"
#include "bem/base/Parallel.hpp"

#include <algorithm>
#include <vector>

namespace epafi::bem {

// Products and submatrices of any size.

/// C += s A B, and C += s Aᵀ B; in parallel, see byColumns
void addProduct(double s, ConstMatrixView a, ConstMatrixView b, MatrixView c);
void addTransposedProduct(double s, ConstMatrixView a, ConstMatrixView b, MatrixView c);
/// A B, and Aᵀ B
Matrix product(ConstMatrixView a, ConstMatrixView b);
Matrix transposedProduct(ConstMatrixView a, ConstMatrixView b);
Vector product(ConstMatrixView a, const Vector& x);
Vector transposedProduct(ConstMatrixView a, const Vector& x);

/// B += A
inline void addTo(MatrixView b, ConstMatrixView a) {
  for (Index j = 0; j < a.columns(); ++j)
    for (Index i = 0; i < a.rows(); ++i)
      b(i, j) += a(i, j);
}

inline Matrix transposed(ConstMatrixView a) {
  Matrix result = Matrix::unset(a.columns(), a.rows());
  for (Index j = 0; j < a.columns(); ++j)
    for (Index i = 0; i < a.rows(); ++i)
      result(j, i) = a(i, j);
  return result;
}

inline Matrix rowsOf(ConstMatrixView x, const std::vector<Index>& rows) {
  Matrix result = Matrix::unset(static_cast<Index>(rows.size()), x.columns());
  for (Index j = 0; j < x.columns(); ++j)
    for (std::size_t i = 0; i < rows.size(); ++i)
      result(static_cast<Index>(i), j) = x(rows[i], j);
  return result;
}
inline void putRows(ConstMatrixView from, const std::vector<Index>& rows, MatrixView x) {
  for (Index j = 0; j < x.columns(); ++j)
    for (std::size_t i = 0; i < rows.size(); ++i)
      x(rows[i], j) = from(static_cast<Index>(i), j);
}
inline Matrix stacked(ConstMatrixView a, ConstMatrixView b) {
  Matrix result = Matrix::unset(a.rows() + b.rows(), a.columns());
  for (Index j = 0; j < a.columns(); ++j) {
    std::copy_n(a.column(j), a.rows(), result.column(j));
    std::copy_n(b.column(j), b.rows(), result.column(j) + a.rows());
  }
  return result;
}

/// Calls action(first, count) for blocks of columns in parallel; `work`: total work [ns].
template <class Action>
void byColumns(Index columns, double work, const Action& action) {
  constexpr Index width = 128;
  parallelFor({(columns + width - 1) / width, work},
              [&](Index k) { action(k * width, std::min(width, columns - k * width)); });
}

}  // namespace epafi::bem
