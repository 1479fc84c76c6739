#pragma once

#include "bem/base/Matrix.hpp"
#include "bem/mesh/Mesh.hpp"

namespace epafi::bem {

class Space;

/// The rotation r(x) = (-(y - c₂), x - c₁) about the boundary's centroid c on a mesh with
/// arcs, where it is no polynomial of arc length.
///
/// A vector u of displacements stands for
///
///   Σ_j u_j φ_j + ω(u) (r - r_I),   ω(u) = q · u,   q · r_I = 1,
///
/// r_I the rotation interpolated, q_j = ∫ φ_j · r ds / <r_I, r>: as many unknowns as
/// without, and r itself among them.  So every functional F of displacements has
///
///   F_j + q_j (F(r) - F · r_I)  in place of F_j,              [doc/theory/operators.md]
///
/// and every operator that does not feel r, those of P u = u - ω(u) r_I.
class Rotation {
 public:
  /// Of the plain polynomials of a space.
  explicit Rotation(const Space& space);

  const Vector& motion() const { return motion_; }          ///< r_I
  const Vector& functional() const { return functional_; }  ///< q
  Vec2 centre() const { return centre_; }

  double amount(const Vector& u) const;
  /// P u
  Vector without(Vector u) const;
  /// r(x) of a scaled point.
  Vec2 at(Vec2 x) const { return turnLeft(x - centre_); }

  /// Adds what the rest of the rotation does to a functional: rest = F(r) - F · r_I, which
  /// is F(r - r_I).
  void complete(double rest, Vector& functional) const;

 private:
  Vec2 centre_;
  Vector motion_;
  Vector functional_;
};

}  // namespace epafi::bem
