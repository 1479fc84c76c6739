#pragma once

#include "bem/base/DenseAlgebra.hpp"

#include <algorithm>
#include <mpi.h>
#include <vector>

namespace epafi::bem {

/// An n x m matrix dealt out by rows, and the same dealt out by columns.
///
/// Both in the blocks of shareOf.  Moves a few columns of every process at a time, so
/// that messages and what is needed beside the two matrices stay small.
class Redeal {
 public:
  /// Local; allocates the buffers.
  Redeal(MPI_Comm comm, Index n, Index m);

  Index columns() const { return share(rank_, m_).size(); }

  /// All rows of my columns, from my rows of all columns; overwrites and returns
  /// `columns`.  Collective.
  Matrix toColumns(const Matrix& rows, Matrix columns);

  /// The way back, which overwrites and returns `rows`.  Collective.
  Matrix toRows(const Matrix& columns, Matrix rows);

 private:
  static constexpr Index width_ = 256;

  /// What lies at a process's place in a buffer.
  struct Pieces {
    std::vector<int> counts;
    std::vector<int> starts;
  };

  Rows share(int rank, Index count) const;
  Rows chunk(int rank, Index offset) const;
  template <class Count>
  Pieces pieces(const Count& count) const;
  Pieces byRows(Index offset) const;
  Pieces byColumns(Index offset) const;
  void exchange(const Pieces& sent, const Pieces& received);

  MPI_Comm comm_;
  int rank_ = 0;
  int processes_ = 1;
  Index n_;
  Index m_;
  Vector sent_;
  Vector received_;
};

/// What a rank has of n indices dealt out in blocks of ceil(n/P); the last ranks may have
/// none.
inline Rows shareOf(int rank, int processes, Index n) {
  const Index height = (n + processes - 1) / processes;
  return {std::min(n, rank * height), std::min(n, (rank + 1) * height)};
}

}  // namespace epafi::bem
