#include "bem/base/Matrix.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace epafi::bem {

namespace {

// A column is a whole number of cache lines, and the stride never a multiple of 512
// bytes.
Index paddedStride(Index rows) {
  const Index lines = std::max<Index>(1, (rows + 7) / 8);
  return 8 * (lines % 8 == 0 ? lines + 1 : lines);
}

}  // namespace

void Matrix::Free::operator()(double* p) const { std::free(p); }

Matrix::Matrix(Index rows, Index columns)
    : rows_(rows), columns_(columns), stride_(paddedStride(rows)) {
  const std::size_t count =
      static_cast<std::size_t>(stride_) * std::max<Index>(1, columns);
  auto* memory = static_cast<double*>(std::aligned_alloc(64, count * sizeof(double)));
  if (memory == nullptr)
    throw std::bad_alloc();
  data_.reset(memory);
  std::fill_n(memory, count, 0.0);
}

Matrix Matrix::copy() const {
  Matrix result(rows_, columns_);
  for (Index j = 0; j < columns_; ++j)
    std::copy_n(column(j), rows_, result.column(j));
  return result;
}

}  // namespace epafi::bem
