#pragma once

#include <cassert>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace epafi::bem {

/// Index of an unknown or a row: wide enough that n² never overflows.
using Index = std::ptrdiff_t;

/// An index as the index type of standard containers.
constexpr std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// A size or an index as the integer type of BLAS, LAPACK and MPI.
constexpr int asInt(Index i) { return static_cast<int>(i); }

/// Deleter of the memory of a matrix.
struct FreeMatrix {
  std::size_t mapped = 0;  ///< bytes mapped from the system; 0: heap memory
  void operator()(double* p) const;
};

/// A dense column-major matrix of doubles.
///
/// stride(), the leading dimension, is padded so that it is not a multiple of a page, since
/// strides of powers of two cause cache conflicts.  A matrix is movable, and copied only by
/// copy().
class Matrix {
 public:
  Matrix() = default;
  Matrix(Index rows, Index columns);  ///< all entries zero
  /// Entries have no value: for a result that is written as a whole.
  static Matrix unset(Index rows, Index columns);

  /// The other is empty then.
  Matrix(Matrix&& other) noexcept { *this = std::move(other); }
  Matrix& operator=(Matrix&& other) noexcept;
  Matrix copy() const;

  /// Keeps the first `columns` columns and releases the memory of the others.
  void shrink(Index columns);

  Index rows() const { return rows_; }
  Index columns() const { return columns_; }
  Index stride() const { return stride_; }
  bool empty() const { return rows_ == 0 || columns_ == 0; }

  double* data() { return data_.get(); }
  const double* data() const { return data_.get(); }
  double* column(Index j) { return data_.get() + j * stride_; }
  const double* column(Index j) const { return data_.get() + j * stride_; }

  /// \pre i is a row, j a column
  double& operator()(Index i, Index j) {
    assert(has(i, j));
    return data_[i + j * stride_];
  }
  double operator()(Index i, Index j) const {
    assert(has(i, j));
    return data_[i + j * stride_];
  }

 private:
  bool has(Index i, Index j) const {
    return 0 <= i && i < rows_ && 0 <= j && j < columns_;
  }

  Index rows_ = 0;
  Index columns_ = 0;
  Index stride_ = 1;
  std::unique_ptr<double[], FreeMatrix> data_;
};

using Vector = std::vector<double>;

/// An entry of a sparse matrix.
struct Entry {
  Index row;
  Index column;
  double value;
};

}  // namespace epafi::bem
