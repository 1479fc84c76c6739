#pragma once

#include "bem/geometry/Continuation.hpp"

namespace epafi::contact {

/// The side of a body at a point, as far as the direction of contact depends on it.
struct SideShape {
  bem::Vec2 normal;      ///< outward
  double curvature = 0;  ///< > 0: convex
  /// From the point on.
  bem::Continuations beyond{};
};

/// \param normal that of the curve at t  \param beyond the curve
SideShape shapeAt(const bem::Curve& curve, bem::Vec2 normal,
                  const bem::Continuations& beyond, double t);

/// A direction in which displacements and tractions are taken, d of contact or d turned left.
struct Direction {
  bem::Vec2 unit{};
  /// What does not count along it: a rotation by one of each body about the centre of its arc, which
  /// leaves the arc where it is.
  double ownTurn = 0;
  double oppositeTurn = 0;
  // what d is worth
  double angle = 0;  ///< between the sides: of -n₂ against n₁
  double parting =
      0;  ///< κ₁ κ₂ / (κ₁ + κ₂): convex sides that slide by δ part by half of that times δ²
};

/// The direction of the linearised gap, of pressure and opening, at a point and what is opposite to it, the same whichever
/// side is the first,
///
///   d = (w₂ n₁ - w₁ n₂) / |w₂ n₁ - w₁ n₂|,   w = |κ|, or |κ|^½ where one side is concave,
///
/// the normal of the flatter side for the most part.  A corner near by counts as the curvature that
/// turns the normal into the other one on the way to it, which fades out at a quarter of a line or
/// circle; two straight sides turn at their next corners, however far.
///                                                      [doc/theory/contact.md, Directions]
Direction directionBetween(const SideShape& own, const SideShape& opposite);

}  // namespace epafi::contact
