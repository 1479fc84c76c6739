#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/geometry/Curve.hpp"

#include <optional>
#include <vector>

namespace epafi::contact {

/// The way from a curve to what lies opposite: along its own outward normals.
///                                                    [doc/theory/contact.md, Several bodies]

/// Where the line x + s n meets a curve: s, and the parameter there.
struct Crossing {
  double distance = 0;  ///< s
  double t = 0;
};

/// Of the crossings with the whole line or circle that a curve is a part of and that face x,
/// n · n(t) < 0: the one of smallest |s| among those with |t| <= 1 (but for rounding), else the
/// one with the smallest |t|; nothing where there is none.
std::optional<Crossing> crossing(bem::Vec2 x, bem::Vec2 n, const bem::Curve& curve);

/// Is a crossing on its curve, but for rounding?
inline bool isOn(const Crossing& crossing) { return std::abs(crossing.t) <= 1 + 1e-11; }

/// The parameter t of the side's point whose normal's line leads to y; it may lie outside
/// [-1, 1].
double footOn(const bem::Curve& side, bem::Vec2 y);

/// A stretch of a side that faces one curve, t in [begin, end].
struct Facing {
  double begin = -1;
  double end = 1;
  int curve = 0;  ///< index into the curves opposite
};

/// What of a side faces which of some curves, in order: at each point that of the smallest
/// |s| <= reach, gaps between the stretches where nothing is opposite.  Stretches end where the
/// ends of curves, and points where they turn away, lie opposite.
std::vector<Facing> facing(const bem::Curve& side,
                           const std::vector<bem::Curve>& opposite, double reach);

}  // namespace epafi::contact
