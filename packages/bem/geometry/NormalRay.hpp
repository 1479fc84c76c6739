#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/geometry/Curve.hpp"

#include <optional>
#include <vector>

namespace epafi::bem {

/// The way from a curve to what lies opposite: along its own outward normals.
///                                                    [doc/theory/contact.md, Several bodies]

/// Where the line x + s n meets a curve: s, and the parameter there.
struct Crossing {
  double distance = 0;  ///< s
  double t = 0;
};

/// Crossing with the full line or circle of a curve at a point that faces x, n · n(t) < 0: the one
/// with the smallest |s| among those with |t| <= 1 (up to rounding), else the one with the
/// smallest |t|; empty if there is none.
std::optional<Crossing> crossing(Vec2 x, Vec2 n, const Curve& curve);

/// Is a crossing on its curve, up to rounding?
inline bool isOn(const Crossing& crossing) { return std::abs(crossing.t) <= 1 + 1e-11; }

/// Parameter t of the point of the side whose normal line contains y; it may be outside
/// [-1, 1].
double footOn(const Curve& side, Vec2 y);

/// A stretch of a side that faces one curve, t in [begin, end].
struct Facing {
  double begin = -1;
  double end = 1;
  int curve = 0;  ///< index into the curves opposite
};

/// Stretches of a side and the curves that they face, ascending in t: at each point the curve with
/// the smallest |s| <= reach; parts of the side that face no curve are omitted.  Stretches end
/// opposite to ends of curves and to points where curves turn away.
std::vector<Facing> facing(const Curve& side, const std::vector<Curve>& opposite,
                           double reach);

}  // namespace epafi::bem
