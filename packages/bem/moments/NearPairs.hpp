#pragma once

#include "bem/moments/FarPairs.hpp"
#include "bem/quadrature/Graded.hpp"

#include <vector>

namespace epafi::bem {

/// Moments of two elements that coincide, touch or lie closer than half the larger one's
/// length: closed form on the larger one, eight points of the smaller one at once; a rule
/// graded toward the feet of the inner element's end points, where its potential has
/// logarithms. [doc/theory/operators.md]
///
/// One for each thread: it holds what is being worked on.
class NearMoments {
 public:
  /// Of (e, f) into one lane; all others are left alone.
  void evaluate(const Mesh& mesh, int e, int f, TileMoments& moments, int lane,
                InstructionSet set = largestInstructionSet());

 private:
  std::vector<AlignedLane> sums_;
};

/// The same where one of the elements is an arc, perhaps of both and of itself: the larger one's
/// potential at the points `rule` of the smaller one.
void nearArcMoments(const Mesh& mesh, int e, int f, const GradedRule& rule,
                    TileMoments& moments, int lane);

}  // namespace epafi::bem
