#include "bem/tpetra/BlockCyclic.hpp"

#include "bem/base/Error.hpp"
#include "bem/tpetra/Scalapack.hpp"

#include <algorithm>
#include <limits>

namespace epafi::bem {

namespace {

constexpr int zero = 0;
constexpr int one = 1;

int sizeOf(MPI_Comm comm) {
  int size = 1;
  MPI_Comm_size(comm, &size);
  return size;
}

/// The largest divisor of p up to √p.
int gridRows(int p) {
  int rows = 1;
  for (int r = 1; r * r <= p; ++r)
    if (p % r == 0)
      rows = r;
  return rows;
}

/// How many of n indices this row or column of the grid has.
int share(Index n, int block, int me, int processes) {
  const int size = static_cast<int>(n);
  return numroc_(&size, &block, &me, &zero, &processes);
}

}  // namespace

ProcessGrid::ProcessGrid(MPI_Comm comm, int rows, int columns)
    : handle_(Csys2blacs_handle(comm)), context_(handle_) {
  Cblacs_gridinit(&context_, "R", rows, columns);
  Cblacs_gridinfo(context_, &rows_, &columns_, &row_, &column_);
}

ProcessGrid::~ProcessGrid() {
  Cblacs_gridexit(context_);
  Cfree_blacs_system_handle(handle_);
}

Layouts::Layouts(MPI_Comm comm)
    : byRows_(comm, sizeOf(comm), 1),
      cyclic_(comm, gridRows(sizeOf(comm)), sizeOf(comm) / gridRows(sizeOf(comm))) {}

BlockCyclic::BlockCyclic(const Layouts& layouts, Index n, Index m)
    : layouts_(&layouts), rows_(static_cast<int>(n)), columns_(static_cast<int>(m)) {
  const ProcessGrid& grid = layouts.cyclic();
  local_ = Matrix(share(n, block, grid.row(), grid.rows()),
                  share(m, block, grid.column(), grid.columns()));
  if (local_.stride() * local_.columns() > std::numeric_limits<int>::max())
    throw NumericalError(message("a matrix of ", n, " x ", m,
                                 " needs more processes: ScaLAPACK counts no more than ",
                                 std::numeric_limits<int>::max(), " entries on each"));
  const int context = grid.context();
  const int stride = static_cast<int>(local_.stride());
  int info = 0;
  descinit_(descriptor_.data(), &rows_, &columns_, &block, &block, &zero, &zero, &context,
            &stride, &info);
}

std::array<int, 9> BlockCyclic::rowDescriptor(const Matrix& rows) const {
  const ProcessGrid& grid = layouts_->byRows();
  const int context = grid.context();
  const int height = std::max(1, (rows_ + grid.rows() - 1) / grid.rows());
  const int width = std::max(1, columns_);
  const int stride = static_cast<int>(rows.stride());
  std::array<int, 9> descriptor{};
  int info = 0;
  descinit_(descriptor.data(), &rows_, &columns_, &height, &width, &zero, &zero, &context,
            &stride, &info);
  return descriptor;
}

/// Calls move(first column, columns), counted from 1, for panels of about 64 MB.
template <class Move>
void BlockCyclic::forPanels(const Move& move) const {
  if (rows_ == 0)
    return;
  const int unit = block * layouts_->cyclic().columns();
  const int width = unit * std::max(1, (1 << 23) / rows_ / unit);
  for (int first = 0; first < columns_; first += width) {
    const int start = first + 1;
    const int count = std::min(width, columns_ - first);
    move(start, count);
  }
}

void BlockCyclic::takeRows(const Matrix& rows) {
  const std::array<int, 9> source = rowDescriptor(rows);
  const int context = layouts_->byRows().context();
  forPanels([&](const int& first, const int& count) {
    pdgemr2d_(&rows_, &count, rows.data(), &one, &first, source.data(), local_.data(),
              &one, &first, descriptor_.data(), &context);
  });
}

void BlockCyclic::giveRows(Matrix& rows) const {
  const std::array<int, 9> target = rowDescriptor(rows);
  const int context = layouts_->byRows().context();
  forPanels([&](const int& first, const int& count) {
    pdgemr2d_(&rows_, &count, local_.data(), &one, &first, descriptor_.data(),
              rows.data(), &one, &first, target.data(), &context);
  });
}

/// Calls visit(local row, row) for what this process has of the only column.
template <class Visit>
void BlockCyclic::forColumn(const Visit& visit) const {
  const ProcessGrid& grid = layouts_->cyclic();
  if (grid.column() != 0)
    return;
  for (Index i = 0; i < local_.rows(); ++i)
    visit(i, (i / block * grid.rows() + grid.row()) * block + i % block);
}

void BlockCyclic::takeColumn(const Vector& column) {
  forColumn([&](Index mine, Index row) { local_(mine, 0) = column[row]; });
}

Vector BlockCyclic::giveColumn() const {
  Vector column(static_cast<std::size_t>(rows_));
  forColumn([&](Index mine, Index row) { column[row] = local_(mine, 0); });
  return column;
}

}  // namespace epafi::bem
