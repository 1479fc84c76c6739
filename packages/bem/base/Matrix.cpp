#include "bem/base/Matrix.hpp"

#include <algorithm>
#include <cstdlib>
#include <new>
#include <sys/mman.h>

namespace epafi::bem {

namespace {

constexpr std::size_t hugePage = std::size_t{1} << 21;
constexpr std::size_t pageSize = hugePage / sizeof(double);

// A column is a whole number of cache lines, and the stride never a multiple of 512
// bytes.
Index paddedStride(Index rows) {
  const Index lines = std::max<Index>(1, (rows + 7) / 8);
  return 8 * (lines % 8 == 0 ? lines + 1 : lines);
}

}  // namespace

void FreeMatrix::operator()(double* p) const {
  if (mapped > 0)
    munmap(p, mapped);
  else
    std::free(p);
}

Matrix::Matrix(Index rows, Index columns)
    : rows_(rows), columns_(columns), stride_(paddedStride(rows)) {
  const std::size_t count =
      static_cast<std::size_t>(stride_) * std::max<Index>(1, columns);
  // large matrices on huge pages: assembly jumps from column to column, and faults cost
  const std::size_t alignment = count * sizeof(double) < hugePage ? 64 : hugePage;
  const std::size_t bytes =
      (count * sizeof(double) + alignment - 1) / alignment * alignment;
  auto* memory = static_cast<double*>(std::aligned_alloc(alignment, bytes));
  if (memory == nullptr)
    throw std::bad_alloc();
  if (alignment == hugePage)
    madvise(memory, bytes, MADV_HUGEPAGE);  // advice: nothing is lost where it is refused
  data_.reset(memory);
  // the first touch of fresh memory costs as much as filling it ten times
  const auto pages = static_cast<std::ptrdiff_t>(count / pageSize);
#pragma omp parallel for if (pages > 1)
  for (std::ptrdiff_t page = 0; page <= pages; ++page) {
    const std::size_t begin = static_cast<std::size_t>(page) * pageSize;
    std::fill_n(memory + begin, std::min(pageSize, count - begin), 0.0);
  }
}

// Fresh pages of the system are zero.  They are small ones here: a huge page would span
// many columns, and with them the upper triangle.
Matrix Matrix::lowerTriangle(Index rows, Index columns) {
  Matrix result(rows, columns, paddedStride(rows));
  const std::size_t bytes = sizeof(double) * static_cast<std::size_t>(result.stride_) *
                            static_cast<std::size_t>(std::max<Index>(1, columns));
  void* memory =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED)
    throw std::bad_alloc();
  result.data_ = {static_cast<double*>(memory), FreeMatrix{bytes}};
  return result;
}

Matrix Matrix::copyLower(Index firstRow) const {
  Matrix result = lowerTriangle(rows_, columns_);
  for (Index j = 0; j < columns_; ++j) {
    const Index first = std::clamp<Index>(j - firstRow, 0, rows_);
    std::copy(column(j) + first, column(j) + rows_, result.column(j) + first);
  }
  return result;
}

Matrix Matrix::copy() const {
  Matrix result(rows_, columns_);
  for (Index j = 0; j < columns_; ++j)
    std::copy_n(column(j), rows_, result.column(j));
  return result;
}

}  // namespace epafi::bem
