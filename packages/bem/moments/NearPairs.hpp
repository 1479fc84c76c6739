#pragma once

#include "bem/moments/FarPairs.hpp"
#include "bem/quadrature/Graded.hpp"

#include <vector>

namespace epafi::bem {

/// Moments of a near pair of elements (equal, touching or closer than half the larger length):
/// closed form on the larger element, for eight points of the smaller one at a time; a rule on
/// the smaller one that is graded toward the projections of the end points of the larger one,
/// where its potential has logarithms.                 [doc/theory/operators.md]
/// Has work arrays: use one object per thread.
class NearMoments {
 public:
  /// Writes the moments of (e, f) to one lane; other lanes stay as they are.
  void evaluate(const Mesh& mesh, int e, int f, TileMoments& moments, int lane,
                InstructionSet set = largestInstructionSet());

 private:
  std::vector<AlignedLane> sums_;
};

/// Moments of a near pair with at least one arc: potential of the larger element at the points
/// `rule` of the smaller one.
void nearArcMoments(const Mesh& mesh, int e, int f, const GradedRule& rule,
                    TileMoments& moments, int lane);

}  // namespace epafi::bem
