#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/mesh/Mesh.hpp"

namespace epafi::bem {

class Space;

/// Exact rotation r(x) = (-(y - c₂), x - c₁) about the centroid c of the boundary on a mesh
/// with arcs, where r is not a polynomial of arc length.
///
/// A displacement vector u represents
///
///   Σ_j u_j φ_j + ω(u) (r - r_I),   ω(u) = q · u,   q · r_I = 1,
///
/// r_I the interpolant of r, q_j = ∫ φ_j · r ds / <r_I, r>.  The number of unknowns is that of
/// polynomials, and r_I represents r.  A functional F of displacements has the entries
///
///   F_j + q_j (F(r) - F · r_I)  instead of F_j,               [doc/theory/operators.md]
///
/// and an operator with A r = 0 becomes A P, P u = u - ω(u) r_I.
class Rotation {
 public:
  /// \param space numbers the polynomial displacements
  explicit Rotation(const Space& space);

  const Vector& motion() const { return motion_; }          ///< r_I
  const Vector& functional() const { return functional_; }  ///< q
  Vec2 centre() const { return centre_; }

  double amount(const Vector& u) const;  ///< ω(u)
  /// P u
  Vector without(Vector u) const;
  /// r(x) of a scaled point.
  Vec2 at(Vec2 x) const { return turnLeft(x - centre_); }

  /// Adds rest q to the coefficients F_j of a functional, rest = F(r) - F · r_I
  /// = F(r - r_I).
  void complete(double rest, Vector& functional) const;

 private:
  Vec2 centre_;
  Vector motion_;
  Vector functional_;
};

}  // namespace epafi::bem
