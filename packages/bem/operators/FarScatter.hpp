#pragma once

#include "bem/operators/Assembly.hpp"
#include "bem/operators/FarBlocks.hpp"

namespace epafi::bem {

/// Adds far pairs to the rows of V, K and W that are mine, tile by tile: a group of
/// consecutive elements f against a run of elements e behind them.
///
/// Entries by columns of f are long stretches of rows and are added at once; those of K
/// by columns of e are short, and are collected until the tile is full.
///
/// One for each thread.  A group writes columns of its own f by rows of elements from its
/// first one on, and rows of its own f by columns of these: zeros, too, are read and
/// written, so nothing before the group is touched, and groups that share no node may be
/// added at the same time.
class FarScatter {
 public:
  FarScatter(const Space& space, const Lame& lame, const DenseAlgebra& algebra,
             Operators& out);

  /// Begins the tile of the elements f of a group and a run.
  void begin(const ElementRange& group, const ElementRun& run);

  /// Adds the far pairs of an f of the group, as ElementRuns chose them from the run.
  /// Elements that close their loop must not be among them.  The ends of edges need more,
  /// see FarBlocks::phase, of which the values remain until the next call.
  const FarBlocks& add(int f, const FarLanes& chosen, const FarBatch& batch);

  /// Adds what was collected.
  void finish();

  /// A stretch of rows to add to a column of a matrix.
  struct Stretch {
    double* to;
    const double* from;
    Index size;
    double scale;
  };

 private:
  struct Target {
    Matrix& matrix;
    const Rows& mine;
  };
  /// `from` has the rows first, first + 1, ... of a column; only mine are added.
  void append(const Target& target, Index first, Index column, const double* from,
              Index size, double scale);
  void collect(int f);

  const Space& space_;
  Rows densityRows_;
  Rows displacementRows_;
  Operators& out_;
  FarBlocks blocks_;
  std::array<double, largestDegree + 1> slopes_{};

  const ElementRun* run_ = nullptr;
  int front_ = 0;         ///< the first element of the run that is not before the group
  Index groupStart_ = 0;  ///< of the group's densities
  Index groupSize_ = 0;
  bool isEmpty_ = true;
  Vector collected_;  ///< the group's densities x the run's displacements
  std::vector<Stretch> stretches_;
};

}  // namespace epafi::bem
