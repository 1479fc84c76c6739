#pragma once

#include "bem/moments/FarPairs.hpp"

#include <vector>

namespace epafi::bem {

/// The elements first ... last - 1.
struct ElementRange {
  int first = 0;
  int last = 0;
  bool contain(int e) const { return first <= e && e < last; }
};

/// Up to eight elements in a row of one loop, first ... last - 1, with a circle around
/// them.
struct ElementRun {
  FarBatch elements{};  ///< wx, wy: their middles, scaled; lanes beyond the last dropped
  int first = 0;
  int last = 0;
  Vec2 centre;
  double radius = 0;
  double largestHalf = 0;
  int degree = 0;           ///< the largest
  int densities = 0;        ///< the largest number of them
  int loop = 0;             ///< loops are counted from 0
  bool closesLoop = false;  ///< behind the last is the loop's first node
  double angle = 0;         ///< by which one turns, the largest
};

/// Which pairs of an element and a run are far, and the Gauss orders that serve them all.
struct FarLanes {
  bool far[lanes] = {};
  int count = 0;
  bool atOnce = false;  ///< by their circle, which is far enough for plain coordinates
  int columns = 0;      ///< largest degree among the far ones
  FarOrder smooth;      ///< without what polynomials cost on top
  FarOrder own[lanes];  ///< of each pair, unless at once
};

/// A mesh in runs of eight; shorter ones end loops.
class ElementRuns {
 public:
  explicit ElementRuns(const Mesh& mesh);

  const Mesh& mesh() const { return *mesh_; }
  int size() const { return static_cast<int>(runs_.size()); }
  int runOf(int e) const { return runOf_[e]; }
  const ElementRun& operator[](int r) const { return runs_[r]; }

  /// The far pairs of e and the wanted elements of run r; fills the batch.  One look
  /// suffices when all are wanted and the circle is far.  Whether a pair is far does not
  /// depend on which of the two is e, unless pairs that need more than `largestOuter`
  /// Gauss points on e (beside the degree's share) are asked to count as near; 7 are
  /// always enough for circles.
  FarLanes choose(int e, int r, const ElementRange& wanted, FarBatch& batch,
                  int largestOuter = largestSmoothOrder) const;

 private:
  bool chooseAtOnce(int e, const ElementRun& run, FarLanes& pairs, FarBatch& batch) const;

  const Mesh* mesh_;
  std::vector<ElementRun> runs_;
  std::vector<int> runOf_;
};

}  // namespace epafi::bem
