#pragma once

#include "bem/base/Matrix.hpp"

#include <algorithm>
#include <cassert>
#include <type_traits>

namespace epafi::bem {

/// Numbers of a matrix, or of some of its rows and columns, that stay where they are.  Number: double
/// or const double.
template <class Number>
class ViewOf {
 public:
  using Owner = std::conditional_t<std::is_const_v<Number>, const Matrix, Matrix>;

  // NOLINTNEXTLINE(google-explicit-constructor): a matrix is where a view is asked for
  ViewOf(Owner& all) : ViewOf(all.data(), all.rows(), all.columns(), all.stride()) {}
  /// A vector as a matrix with one column.
  using Entries = std::conditional_t<std::is_const_v<Number>, const Vector, Vector>;
  explicit ViewOf(Entries& v)
      : ViewOf(v.data(), static_cast<Index>(v.size()), 1, static_cast<Index>(v.size())) {}
  ViewOf(Number* data, Index rows, Index columns, Index stride)
      : data_(data), rows_(rows), columns_(columns), stride_(stride) {}
  /// A view that does not write.
  // NOLINTNEXTLINE(google-explicit-constructor)
  operator ViewOf<const Number>() const { return {data_, rows_, columns_, stride_}; }

  Index rows() const { return rows_; }
  Index columns() const { return columns_; }
  Index stride() const { return stride_; }
  bool empty() const { return rows_ == 0 || columns_ == 0; }
  Number* data() const { return data_; }
  Number* column(Index j) const { return data_ + j * stride_; }
  Number& operator()(Index i, Index j) const {
    assert(0 <= i && i < rows_ && 0 <= j && j < columns_);
    return data_[i + j * stride_];
  }

  Matrix copy() const {
    Matrix result = Matrix::unset(rows_, columns_);
    for (Index j = 0; j < columns_; ++j)
      std::copy_n(column(j), rows_, result.column(j));
    return result;
  }

  /// Rows, or columns, first ... last - 1.
  ViewOf rowsBetween(Index first, Index last) const {
    assert(0 <= first && first <= last && last <= rows_);
    return {data_ + first, last - first, columns_, stride_};
  }
  ViewOf columnsBetween(Index first, Index last) const {
    assert(0 <= first && first <= last && last <= columns_);
    return {column(first), rows_, last - first, stride_};
  }

 private:
  Number* data_ = nullptr;
  Index rows_ = 0;
  Index columns_ = 0;
  Index stride_ = 1;
};
using MatrixView = ViewOf<double>;
using ConstMatrixView = ViewOf<const double>;

inline ConstMatrixView rowsBetween(ConstMatrixView a, Index first, Index last) {
  return a.rowsBetween(first, last);
}
inline ConstMatrixView columnsBetween(ConstMatrixView a, Index first, Index last) {
  return a.columnsBetween(first, last);
}

}  // namespace epafi::bem
