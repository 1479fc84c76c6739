#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/quadrature/Graded.hpp"
#include "bem/simd/ComplexPack.hpp"

#include <vector>

namespace epafi::bem {

/// A boundary point relative to element e, accurate near a common vertex; b = 0 exactly if it
/// is on the edge of e.
RelativeTarget seenFrom(const Mesh& mesh, int e, const BoundaryPoint& x);

using TargetLanes = TargetOf<ComplexPack>;

/// From z - 1 and z + 1, of which the smaller one is accurate.
EPAFI_INLINE TargetLanes targetAt(const ComplexPack& minus1, const ComplexPack& plus1) {
  Pack squareOfMinus;
  Pack squareOfPlus;
  squareOf(minus1, squareOfMinus);
  squareOf(plus1, squareOfPlus);
  const auto atOne = squareOfMinus < squareOfPlus;
  const Pack b = atOne ? minus1.im : plus1.im;
  return {{atOne ? 1.0 + minus1.re : plus1.re - 1.0, b},
          {atOne ? minus1.re : plus1.re - 2.0, b},
          {atOne ? minus1.re + 2.0 : plus1.re, b}};
}

/// Points of `element` relative to element `source`, eight at a time; the last one is repeated.
std::vector<TargetLanes> seenFrom(const Mesh& mesh, int source, int element,
                                  const std::vector<EndPoint>& points);

/// Eight points (x, y) relative to a segment.
TargetLanes seenFrom(const Curve& segment, const AlignedLane& x, const AlignedLane& y);

TargetLanes packed(const RelativeTarget (&targets)[lanes]);

/// Are all on the curve or on its continuation: b = 0 exactly?
bool areOnLine(const TargetLanes& targets);

/// Appends the end points of element `source` as features of a rule on `element`.
void appendEnds(const Mesh& mesh, int element, int source,
                std::vector<Feature>& features);

}  // namespace epafi::bem
