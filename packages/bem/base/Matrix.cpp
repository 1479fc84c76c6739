#include "bem/base/Matrix.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <sys/mman.h>

namespace epafi::bem {

namespace {

constexpr std::size_t hugePage = std::size_t{1} << 21;
constexpr std::size_t cacheLine = 64;

// A column is a whole number of cache lines, and the stride never a multiple of 512
// bytes.
Index paddedStride(Index rows) {
  const Index lines = std::max<Index>(1, (rows + 7) / 8);
  return 8 * (lines % 8 == 0 ? lines + 1 : lines);
}

std::unique_ptr<double[], FreeMatrix> fromHeap(std::size_t bytes) {
  auto* memory = static_cast<double*>(std::aligned_alloc(cacheLine, bytes));
  if (memory == nullptr)
    throw std::bad_alloc();
  return {memory, FreeMatrix{0}};
}

// Whole huge pages, since assembly jumps from column to column and small pages fault 500
// times as often; straight from the system, which gives zeros, and straight back to it:
// the heap would keep holes.
std::unique_ptr<double[], FreeMatrix> fromSystem(std::size_t bytes) {
  const std::size_t size = (bytes + hugePage - 1) / hugePage * hugePage;
  void* memory = mmap(nullptr, size + hugePage, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED)
    throw std::bad_alloc();
  auto* begin = static_cast<char*>(memory);
  const std::size_t ahead =
      (hugePage - reinterpret_cast<std::uintptr_t>(begin) % hugePage) % hugePage;
  if (ahead > 0)
    munmap(begin, ahead);
  munmap(begin + ahead + size, hugePage - ahead);
  madvise(begin + ahead, size, MADV_HUGEPAGE);  // advice: nothing is lost if refused
  return {reinterpret_cast<double*>(begin + ahead), FreeMatrix{size}};
}

}  // namespace

void FreeMatrix::operator()(double* p) const {
  if (mapped > 0)
    munmap(p, mapped);
  else
    std::free(p);
}

Matrix::Matrix(Index rows, Index columns) : Matrix(unset(rows, columns)) {
  if (data_.get_deleter().mapped == 0)
    std::fill_n(data_.get(), stride_ * std::max<Index>(1, columns), 0.0);
}

Matrix& Matrix::operator=(Matrix&& other) noexcept {
  rows_ = std::exchange(other.rows_, 0);
  columns_ = std::exchange(other.columns_, 0);
  stride_ = std::exchange(other.stride_, 1);
  data_ = std::move(other.data_);
  return *this;
}

Matrix Matrix::unset(Index rows, Index columns) {
  Matrix result;
  result.rows_ = rows;
  result.columns_ = columns;
  result.stride_ = paddedStride(rows);
  const std::size_t bytes = sizeof(double) * static_cast<std::size_t>(result.stride_) *
                            static_cast<std::size_t>(std::max<Index>(1, columns));
  result.data_ = bytes < hugePage ? fromHeap(bytes) : fromSystem(bytes);
  return result;
}

void Matrix::shrink(Index columns) {
  columns_ = columns;
  const std::size_t bytes =
      sizeof(double) * static_cast<std::size_t>(stride_ * std::max<Index>(1, columns));
  const std::size_t kept = (bytes + hugePage - 1) / hugePage * hugePage;
  std::size_t& mapped = data_.get_deleter().mapped;
  if (mapped <= kept)
    return;
  munmap(reinterpret_cast<char*>(data_.get()) + kept, mapped - kept);
  mapped = kept;
}

Matrix Matrix::copy() const {
  Matrix result = unset(rows_, columns_);
  for (Index j = 0; j < columns_; ++j)
    std::copy_n(column(j), rows_, result.column(j));
  return result;
}

}  // namespace epafi::bem
