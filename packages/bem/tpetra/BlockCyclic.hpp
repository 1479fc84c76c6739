#pragma once

#include "bem/base/Matrix.hpp"

#include <array>
#include <mpi.h>

namespace epafi::bem {

/// Processes as a grid of ScaLAPACK's, numbered by rows.
class ProcessGrid {
 public:
  /// Collective.
  ProcessGrid(MPI_Comm comm, int rows, int columns);
  ~ProcessGrid();
  ProcessGrid(const ProcessGrid&) = delete;
  ProcessGrid& operator=(const ProcessGrid&) = delete;

  int context() const { return context_; }
  int rows() const { return rows_; }
  int columns() const { return columns_; }
  int row() const { return row_; }
  int column() const { return column_; }

 private:
  int handle_ = 0;
  int context_ = 0;
  int rows_ = 1;
  int columns_ = 1;
  int row_ = 0;
  int column_ = 0;
};

/// The two layouts of a matrix: by blocks of rows, as Epafi holds it, and block-cyclic,
/// which balances factorisations.  [platform.md 8]
class Layouts {
 public:
  explicit Layouts(MPI_Comm comm);

  const ProcessGrid& byRows() const { return byRows_; }
  const ProcessGrid& cyclic() const { return cyclic_; }

 private:
  ProcessGrid byRows_;  ///< P x 1
  ProcessGrid cyclic_;  ///< as square as P allows
};

/// This process's part of an n x m matrix in blocks of 128 x 128, dealt out cyclically.
class BlockCyclic {
 public:
  static constexpr int block = 128;

  /// All entries zero.
  /// \throws NumericalError if a part would have more entries than ScaLAPACK can count.
  BlockCyclic(const Layouts& layouts, Index n, Index m);

  int rows() const { return rows_; }
  int columns() const { return columns_; }
  double* data() { return local_.data(); }
  const double* data() const { return local_.data(); }
  const int* descriptor() const { return descriptor_.data(); }

  /// A = the matrix of which `rows` are this process's rows, or the other way round.
  /// Collective; in panels of columns, so that messages stay small.
  void takeRows(const Matrix& rows);
  void giveRows(Matrix& rows) const;

  /// The same for one replicated column; giving it is local and leaves zeros where other
  /// processes have entries.
  void takeColumn(const Vector& column);
  Vector giveColumn() const;

 private:
  std::array<int, 9> rowDescriptor(const Matrix& rows) const;
  template <class Move>
  void forPanels(const Move& move) const;
  template <class Visit>
  void forColumn(const Visit& visit) const;

  const Layouts* layouts_;
  int rows_;
  int columns_;
  Matrix local_;
  std::array<int, 9> descriptor_{};
};

}  // namespace epafi::bem
