#pragma once

#include "bem/geometry/Curve.hpp"

#include <vector>

namespace epafi::bem {

/// Do two curves cross or come as close as this?  The smallest distance is taken at an end
/// of one of them, or where both have a common normal, which runs through arcs' centres.
bool meet(const Curve& a, const Curve& b, double tolerance);

/// Do two curves of which one starts or ends where the other does come closer than
/// `tolerance` to each other elsewhere, or leave their common point in the same direction?
/// Closer to such a point than `blind` nothing is looked at: smooth joints touch there.
bool meetElsewhere(const Curve& a, const Curve& b, double tolerance, double blind);

/// How often a ray from p to the right crosses a closed loop of curves is odd.
bool inside(Vec2 p, const std::vector<Curve>& loop);

/// Points of a curve that, with those of the curve it leads to, tell how large it is: its start;
/// of an arc many more, among them those farthest left, right, up and down.
std::vector<Vec2> extent(const Curve& curve);

/// Twice the area between a curve and its chord, > 0 where it bulges to the right.
double twiceAreaBesideChord(const Curve& curve);

}  // namespace epafi::bem
