#pragma once

#include "bem/moments/FarPairs.hpp"

#include <vector>

namespace epafi::bem {

/// Elements first ... last - 1.
struct ElementRange {
  int first = 0;
  int last = 0;
  bool contain(int e) const { return first <= e && e < last; }
};

/// Up to eight consecutive elements of one loop, first ... last - 1, and a circle around
/// them.
struct ElementRun {
  FarBatch elements{};  ///< wx, wy: midpoints, scaled; lanes beyond the last dropped
  int first = 0;
  int last = 0;
  Vec2 centre;
  double radius = 0;
  double largestHalf = 0;
  int degree = 0;           ///< the largest
  int densities = 0;        ///< the largest number on an element
  int loop = 0;             ///< counted from 0
  bool closesLoop = false;  ///< the last element ends at the first node of the loop
  double angle = 0;         ///< largest angle by which an element turns
};

/// The far pairs of an element and a run, and Gauss orders for all of them.
struct FarLanes {
  bool far[lanes] = {};
  int count = 0;
  bool atOnce = false;  ///< the circle is far; plain coordinates are accurate enough
  int columns = 0;      ///< largest degree of the far elements
  FarOrder smooth;      ///< for all pairs, without degreeShare
  FarOrder own[lanes];  ///< for each pair, unless atOnce
};

/// Division of a mesh into runs of eight elements; the last run of a loop may be shorter.
class ElementRuns {
 public:
  explicit ElementRuns(const Mesh& mesh);

  const Mesh& mesh() const { return *mesh_; }
  int size() const { return static_cast<int>(runs_.size()); }
  int runOf(int e) const { return runOf_[e]; }
  const ElementRun& operator[](int r) const { return runs_[r]; }

  /// Selects the far pairs of e and the wanted elements of run r; fills the batch.  A single
  /// test suffices if all elements are wanted and the circle is far.
  /// \param largestOuter pairs that need more Gauss points on e (without degreeShare) count as
  /// near; at least 7, which a far circle needs.  With the default, the result does not depend
  /// on which element of a pair is e.
  FarLanes choose(int e, int r, const ElementRange& wanted, FarBatch& batch,
                  int largestOuter = largestSmoothOrder) const;

 private:
  bool chooseAtOnce(int e, const ElementRun& run, FarLanes& pairs, FarBatch& batch) const;

  const Mesh* mesh_;
  std::vector<ElementRun> runs_;
  std::vector<int> runOf_;
};

}  // namespace epafi::bem
