#pragma once

#include "contact/results/Solved.hpp"

namespace epafi::contact {

/// A point of a contact side of a solution, and the laws between the sides there; dimensionless.
/// Stresses and displacements of the side are arguments, so that they may be those of another
/// multiplier or of a projection.
class ContactPlace {
 public:
  using Element = MultiplierSpace::ContactElement;

  /// Refers to the solution and the element.
  ContactPlace(const Solved& solved, const Element& element, double t);

  double t() const { return t_; }
  const bem::SurfacePoint& place() const { return place_; }
  const Opposite::Point& opposite() const { return opposite_; }

  /// φ(λₙ), by which the surfaces yield.
  double closing(double pressure) const;
  /// Worn depth.
  double worn() const { return wornBy(&Wear::depth); }
  /// By how far the sides are apart: g + φ(λₙ) + w - [u]·n.  `normal`: u·n of the side
  double opening(double pressure, double normal) const;
  /// [u]·t less elastic shear and given sliding; in a step of a path its increment, but of bonded
  /// sides all of it.  `tangential`: u·t of the side, likewise
  double slip(double tangential, double shear) const;
  /// s(λₙ⁺)
  double bound(double pressure) const;
  /// φ' of sides that yield and wear where they are this far apart, as stiff as where the pressure
  /// has closed what overlaps of them against `stiffness`; open sides do not yield.
  double yield(double pressure, double opening, double stiffness) const;
  /// Likewise of shear.
  double shearYield() const;
  /// p/h of the opposite side over that of this side, at least 1.
  double fineness() const;

 private:
  const Conditions::Contact& condition() const { return *element_.condition; }
  double wornBy(Vector Wear::*part) const;

  const Solved& solved_;
  const Element& element_;
  double t_;
  bem::SurfacePoint place_;
  Opposite::Point opposite_;
};

}  // namespace epafi::contact
