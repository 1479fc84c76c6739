#pragma once

#include "bem/geometry/CurveTree.hpp"

#include <vector>

namespace epafi::bem {

/// Is the distance of two curves at most `tolerance`?  The smallest distance is attained at an
/// end of one of them or on a common normal, which contains the centres of arcs.
bool meet(const Curve& a, const Curve& b, double tolerance);

/// For two curves with a common end point: are they closer than `tolerance` elsewhere, or do
/// they leave that point in the same direction?  Points closer to it than `blind` are
/// ignored, since curves with a smooth joint touch there.
bool meetElsewhere(const Curve& a, const Curve& b, double tolerance, double blind);

/// Where two curves cross; touching ones need not be found.
std::vector<Vec2> crossings(const Curve& a, const Curve& b);

/// Is p inside closed loops of curves?  Counts the crossings with a ray to the right.
bool inside(Vec2 p, const CurveTree& loops);

/// Ends of chords along a curve, the ends of the curve among them: one chord of a segment, 32 of an
/// arc.
std::vector<Vec2> chords(const Curve& curve);

/// Points for the diameter and the bounding box of a loop: the starts of chords; of an arc also the
/// extreme points in x and y.
std::vector<Vec2> extent(const Curve& curve);

/// Twice the area between a curve and its chord, > 0 if it bulges to the right.
double twiceAreaBesideChord(const Curve& curve);

}  // namespace epafi::bem
