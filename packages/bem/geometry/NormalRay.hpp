#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/geometry/CurveTree.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace epafi::bem {

/// The way from a curve to what lies opposite: along its own outward normals, or, beside a corner that
/// presses into the other side, along the normals of that one.
///                                                    [doc/theory/contact.md, Several bodies]
enum class Normals { Own, Opposite };

/// Where the line x + s n meets a curve: s, and the parameter there.
struct Crossing {
  double distance = 0;  ///< s
  double t = 0;
};

/// Crossing with the full line or circle of a curve at a point that faces x, n · n(t) < 0: the one
/// with the smallest |s| among those with |t| <= 1 (up to rounding), else the one with the
/// smallest |t|; empty if there is none.
std::optional<Crossing> crossing(Vec2 x, Vec2 n, const Curve& curve);

/// Rounding of places in scaled coordinates, which are of size 1.
constexpr double ofCoordinates = 1e-14;

/// Is a crossing on a curve, up to rounding?  Without that of coordinates there were gaps between the
/// elements of finely graded meshes.
inline bool isOn(const Crossing& crossing, const Curve& curve) {
  constexpr double ofCurve = 1e-11;
  return std::abs(crossing.t) <= 1 + std::max(ofCurve, ofCoordinates / curve.half());
}

/// Likewise what lies opposite to a point x of a side, n its normal there, in the direction
/// sightLine(n, curve, t).
std::optional<Crossing> across(Vec2 x, Vec2 n, const Curve& curve, Normals along);

/// In which direction a point sees the point t of the curve opposite.
inline Vec2 sightLine(Vec2 n, const Curve& curve, double t, Normals along) {
  return along == Normals::Own ? n : -curve.normal(t);
}

/// Parameters t, also outside [-1, 1], of the points of a side whose normal lines contain y: on an
/// arc two, first the one on the same side of the centre as y.
std::vector<double> feetOn(const Curve& side, Vec2 y);

/// The boundaries of two bodies in contact, in the same coordinates, and which of their points see
/// each other: those between which a line crosses neither boundary.  It lies outside both bodies, or,
/// where they overlap, inside both.
class Visibility {
 public:
  /// Everything is seen from everywhere.
  Visibility() = default;
  /// \param own of the body whose points look, \param opposite of the other one; all their curves
  /// \param touching points that are closer than this touch
  Visibility(std::vector<Curve> own, std::vector<Curve> opposite, double touching);

  /// Does a point x of the own body with the normal n see the point x + s n of the opposite one?
  bool sees(Vec2 x, Vec2 n, double s) const;
  /// Adds the parameters of a side of the own body, in any order, between which its points see the
  /// same parts of the opposite one; others may be among them.
  void addChanges(const Curve& side, Vector& places) const;

 private:
  CurveTree own_;
  CurveTree opposite_;
  std::vector<Vec2> crossings_;  ///< of both boundaries
  double touching_ = 0;
};

/// A stretch of a side that faces one curve, t in [begin, end].
struct Facing {
  double begin = -1;
  double end = 1;
  int curve = 0;  ///< index into the curves opposite
};

/// Stretches of a side and the curves that they face, ascending in t: at each point the nearest
/// curve that it sees; parts of the side that see none are omitted.  Stretches end opposite to ends of
/// curves, at points where curves turn away and where something else comes between.
std::vector<Facing> facing(const Curve& side, const CurveTree& opposite,
                           const Visibility& visibility, Normals along = Normals::Own);

/// What a point of a side faces, if anything.
struct FacedPoint {
  int curve = 0;
  Crossing crossing{};
};
std::optional<FacedPoint> faced(const Curve& side, double t, const CurveTree& opposite,
                                const Visibility& visibility,
                                Normals along = Normals::Own);

}  // namespace epafi::bem
