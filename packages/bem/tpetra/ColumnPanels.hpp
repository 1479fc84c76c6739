#pragma once

#include "bem/base/DenseAlgebra.hpp"

#include <algorithm>
#include <array>
#include <mpi.h>
#include <vector>

namespace epafi::bem {

/// The lower triangle of an n x n matrix in panels of columns, dealt out cyclically.
///
/// Panel k has the columns from k * width on, and of these what stands in and below the
/// square on the diagonal; process k mod P has it.  So a process keeps n²/2P numbers, and
/// all have work until the last panels of a factorisation.
class ColumnPanels {
 public:
  static constexpr Index width = 256;

  /// All entries zero.
  ColumnPanels(MPI_Comm comm, Index n);

  MPI_Comm comm() const { return comm_; }
  Index size() const { return n_; }
  int count() const { return static_cast<int>((n_ + width - 1) / width); }

  /// First row and column, columns and rows of panel k.
  Index begin(int k) const { return k * width; }
  Index columns(int k) const { return std::min(width, n_ - begin(k)); }
  Index rows(int k) const { return n_ - begin(k); }

  /// The stride of panel k, known to all: what passes between processes is padded alike.
  Index stride(int k) const { return strides_[k]; }

  int owner(int k) const { return k % processes_; }
  bool isMine(int k) const { return owner(k) == rank_; }
  Matrix& mine(int k) { return mine_[k / processes_]; }
  const Matrix& mine(int k) const { return mine_[k / processes_]; }

  /// Takes the lower triangle of which `rows` are this process's rows.  Collective.
  void take(const Matrix& rows);

 private:
  MPI_Comm comm_;
  int rank_ = 0;
  int processes_ = 1;
  Index n_;
  std::vector<Index> strides_;
  std::vector<Matrix> mine_;
};

/// Panels as they pass all processes: while one is in use, the next may be on its way.
class PanelStream {
 public:
  /// A panel's entries, by columns.
  struct View {
    const double* data;
    Index stride;
  };

  /// Local; allocates the buffers.
  explicit PanelStream(const ColumnPanels& panels);

  /// Sends panel k, or begins to receive it: on all processes, in the order of k, and
  /// after end(k - 1).
  void begin(int k);

  /// Panel k, valid until begin(k + 2).
  View end(int k);

 private:
  double* place(int k) { return buffers_[k % 2].data(); }

  const ColumnPanels& panels_;
  std::array<Matrix, 2> buffers_;
  MPI_Request request_ = MPI_REQUEST_NULL;
};

}  // namespace epafi::bem
