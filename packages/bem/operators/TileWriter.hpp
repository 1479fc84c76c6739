#pragma once

#include "bem/operators/Assembly.hpp"
#include "bem/operators/TileBlocks.hpp"

namespace epafi::bem {

/// What pairs give to the nodes behind the loops' last elements.  These are the loops'
/// first nodes, numbered far from there: kept apart, they are ghosts, one for each loop,
/// and elements are written in any order by several threads.
struct GhostNodes {
  GhostNodes(const Space& space, const ElementRuns& runs);

  std::vector<Index> first;  ///< by loop: its first node's displacement
  Matrix doubleLayer;        ///< densities x 2 ghosts
  /// All displacements, then the ghosts, x 2 ghosts; of two ghosts once, of one with itself
  /// the whole block.
  Matrix hypersingular;

  /// Adds them to the first nodes.
  void fold(Operators& out) const;
};

/// Adds tiles to V, K and W: a group of consecutive elements f, which is a run, against a run
/// of elements e from f on.
///
/// Entries by columns of f are long stretches of rows and are added at once; those of K
/// by columns of e are short, and are collected until the group is through.
///
/// One for each thread.  A group writes columns of its own f by rows of elements from its
/// first one on, and rows of its own f by columns of these: zeros, too, are read and
/// written, so nothing before the group is touched, and groups that share no node may be
/// added at the same time.
class TileWriter {
 public:
  TileWriter(const Space& space, const Lame& lame, Operators& out, GhostNodes& ghosts);

  /// Begins the tiles of the elements f of a group and a run.
  void begin(const ElementRun& group, const ElementRun& run);

  /// Adds the tile of an f of the group with the elements of the run from f on.
  void add(const Tile& tile);

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
  /// `from` has the rows first, first + 1, ... of a column.
  void append(Matrix& matrix, Index first, Index column, const double* from, Index size,
              double scale);
  void appendHypersingular(int f, int k, int c);
  void addCommonNode(int f, const Block& slopes);
  void collect(int f);

  const Space& space_;
  Operators& out_;
  GhostNodes& ghosts_;
  TileBlocks blocks_;

  const ElementRun* group_ = nullptr;
  const ElementRun* run_ = nullptr;
  Index groupStart_ = 0;  ///< of the group's densities
  Index groupSize_ = 0;
  bool isEmpty_ = true;
  Vector collected_;  ///< the group's densities x the run's displacements
  std::vector<Stretch> stretches_;
};

}  // namespace epafi::bem
