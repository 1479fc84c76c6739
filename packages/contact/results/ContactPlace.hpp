#pragma once

#include "contact/results/Solved.hpp"

namespace epafi::contact {

/// A point of a contact side of a solution and the laws between the sides there, dimensionless.
/// Stresses and displacements of the side are arguments, which may be those of another multiplier or
/// of a projection.  Refers to the solution and the element.
struct ContactPlace {
  const Solved& solved;
  const MultiplierSpace::ContactElement& element;
  double t;
  bem::SurfacePoint place = element.mesh->physicalPoint(element.element, t);
  Opposite::Point opposite = solved.problem.opposite().at(element, t);
  bem::Vec2 motion = motionAt(solved.motions, opposite);  ///< of the opposite point

  /// φ(λₙ), by which the surfaces yield.
  double closing(double pressure) const;
  /// A part of Wear where sides wear, else 0.
  double worn(Vector Wear::*part) const;
  /// uₙ = [u]·d, [u] = u - u of the opposite point, without what arcs that turn about their centres add.
  double approach(bem::Vec2 u) const;
  /// By how far the sides are apart, g + φ(λₙ) + w - uₙ.
  double opening(double pressure, bem::Vec2 u) const;
  /// [u]·t less elastic shear and given sliding; in a step of a path its increment, for which
  /// u is one, too, but of bonded sides all of it.
  double slip(bem::Vec2 u, double shear) const;
  /// s(λₙ⁺)
  double bound(double pressure) const;
  /// φ' and what wears, as stiff as where the pressure has closed what overlaps against `stiffness`; open
  /// sides do not yield.
  double yield(double pressure, double opening, double stiffness) const;
  double shearYield() const;
  /// p/h of the opposite side over that of this side, at least 1.
  double fineness() const;
};

}  // namespace epafi::contact
