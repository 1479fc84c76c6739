#pragma once

#include "bem/operators/Assembly.hpp"
#include "bem/operators/PairColumns.hpp"

namespace epafi::bem {

/// Entries of the end nodes of the last elements of the loops.  Each is the first node of its
/// loop, with a distant number.  A ghost node per loop collects these entries, so that
/// threads that write elements in any order do not collide.
struct GhostNodes {
  GhostNodes(const Space& space, const ElementRuns& runs);

  std::vector<Index> first;  ///< by loop: number of its first node's first displacement
  int components;
  Matrix doubleLayer;  ///< densities x components of ghosts
  /// (displacements + ghosts) x ghosts, all components; a pair of ghosts is stored once, diagonal blocks
  /// in full.
  Matrix hypersingular;

  /// Adds the entries to the first nodes.
  void fold(Operators& out) const;
};

/// Adds tiles to V, K and W: elements f of a group (consecutive elements of a run) against the
/// elements e >= f of a run.
///
/// Entries in columns of f are long contiguous pieces of rows and are added directly; entries
/// of K in columns of e are short and are collected until finish().
///
/// One writer per thread.  A group accesses only columns of its f in rows of elements from the
/// first f on, and rows of its f in the columns of these elements.  Groups without a common
/// node may be added concurrently; since zeros are added as well, nothing before the group
/// is accessed.
class TileWriter {
 public:
  TileWriter(const Space& space, Operators& out, GhostNodes& ghosts);

  /// Begins the tiles of a group and a run.
  void begin(const ElementLanes& group, const ElementLanes& run);

  /// Adds entries of an element f of the group with the elements e >= f of the run.
  void add(const PairColumns& columns);

  /// Adds the collected entries of K.
  void finish();

  /// Contiguous entries to add to a column of a matrix.
  struct Stretch {
    double* to;
    const double* from;
    Index size;
    double scale;
  };

 private:
  /// Appends a Stretch for the rows first ... first + size - 1 of a column.
  void append(Matrix& matrix, Index first, Index column, const double* from, Index size,
              double scale);
  void appendHypersingular(const PairColumns& columns, int f, int k, int c);
  void addCommonNode(int f, const PairColumns& columns);
  void collect(const PairColumns& columns, int f);

  const Space& space_;
  Operators& out_;
  GhostNodes& ghosts_;

  const ElementLanes* group_ = nullptr;
  const ElementLanes* run_ = nullptr;
  Index groupStart_ = 0;  ///< first density of the group
  Index groupSize_ = 0;
  bool isEmpty_ = true;
  Vector collected_;  ///< densities of the group x displacements of the run
  std::vector<Stretch> stretches_;
};

}  // namespace epafi::bem
