#pragma once

#include "bem/geometry/Outline.hpp"

#include <vector>

namespace epafi::bem {

/// How a boundary goes on beyond an end of a curve: for a length on the same line or circle, then with
/// another curvature: infinite at a corner, 0 where it bends away from the body or nothing is known.
struct Continuation {
  double length = 0;
  double curvature = 0;

  Continuation inUnits(double unit) const { return {length / unit, curvature * unit}; }
};

/// Beyond the start and the end of a curve, both away from it.
struct Continuations {
  Continuation before{};
  Continuation after{};
  bool turns = true;  ///< may the body turn?  Not if it goes on as its image.

  /// Those of a part of the curve.
  Continuations ofPart(Position start, Position end) const {
    return {{before.length + start.fromStart, before.curvature},
            {after.length + end.toEnd, after.curvature},
            turns};
  }
  Continuations inUnits(double unit) const {
    return {before.inUnits(unit), after.inUnits(unit), turns};
  }
};

/// Are both parts of one line, or of circles of one size that bend to one side, up to rounding?
bool haveOneCurvature(const Curve& a, const Curve& b);

/// By edge of an outline; at an axis of revolution or a line of symmetry it goes on as its image.
std::vector<Continuations> continuations(const Outline& outline);

}  // namespace epafi::bem
