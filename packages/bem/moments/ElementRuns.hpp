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

/// Up to eight elements in a row, first ... last - 1, with a circle around them.
struct ElementRun {
  FarBatch elements{};  ///< wx, wy: their middles, scaled; lanes beyond the last dropped
  int first = 0;
  int last = 0;
  Vec2 centre;
  double radius = 0;
  double largestHalf = 0;
  int degree = 0;  ///< the largest
};

/// Which pairs of an element and a run are far, and the Gauss orders that serve them all.
struct FarLanes {
  bool far[lanes] = {};
  int count = 0;
  bool atOnce = false;   ///< by their circle, which is far enough for plain coordinates
  int columns = 0;       ///< largest degree among the far ones
  PairOrder smooth;      ///< without what polynomials cost on top
  PairOrder own[lanes];  ///< of each pair, unless at once
};

/// The largest smooth order of a far circle.
constexpr int smoothOrderOfCircles = 7;

/// A mesh in runs of eight, the first of them at 0, the next at 8, ...
class ElementRuns {
 public:
  explicit ElementRuns(const Mesh& mesh);

  const Mesh& mesh() const { return *mesh_; }
  int size() const { return static_cast<int>(runs_.size()); }
  const ElementRun& operator[](int r) const { return runs_[static_cast<std::size_t>(r)]; }

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
};

}  // namespace epafi::bem
