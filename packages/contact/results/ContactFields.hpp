#pragma once

#include "contact/results/Solved.hpp"

namespace epafi::contact {

enum class FrictionKind {
  None,  ///< the bound is zero
  Stick,
  Slip
};

/// State of a point of a contact boundary, in the user's units.  t is the outward normal n
/// turned counter-clockwise; λ = -σ(u) n.
struct ContactPoint {
  bem::Vec2 place;
  double pressure = 0;    ///< λₙ [stress]
  double shear = 0;       ///< λₜ [stress]
  double normal = 0;      ///< uₙ, relative to the opposite side [length]
  double tangential = 0;  ///< uₜ, relative to the opposite side [length]
  double sliding =
      0;  ///< given sliding of the opposite side; slip is uₜ - sliding [length]
  double gap = 0;       ///< [length]
  double bound = 0;     ///< slip bound s(λₙ) [stress]
  double closing = 0;   ///< normal compliance φ(λₙ) of the surfaces [length]
  double worn = 0;      ///< worn depth [length]
  double distance = 0;  ///< Σ |slip| while closed [length]
  bool closed = false;  ///< λₙ > 0
  FrictionKind friction = FrictionKind::None;
};

/// The discrete solution as functions on the contact boundaries.
///
/// States by the discrete inequalities, with a tolerance of 1e-9 of the load: closed if λₙ > 0,
/// slip if |λₜ| reaches the bound in the basis of the multiplier.  Bonded points are closed and
/// stick, with an infinite bound.
/// Refers to its arguments, which must outlive it.
class ContactFields {
 public:
  explicit ContactFields(const Solved& solved);

  using Element = MultiplierSpace::ContactElement;
  const std::vector<Element>& elements() const { return multiplierSpace().elements(); }

  const Opposite& opposite() const { return solved_.problem.opposite(); }

  ContactPoint at(const Element& element, double t) const;

  /// Coefficients of λ without arbitrary jumps, see withoutJumps.
  Vector continuous() const;
  /// Value of a multiplier, given by coefficients, at a point [stress].
  MultiplierSpace::Value inUnits(const Vector& multiplier, const Element& element,
                                 double t) const;

  /// λ [stress] and uₜ [length] as in at(), at less cost.
  MultiplierSpace::Value stress(const Element& element, double t) const;
  double slip(const Element& element, double t) const;

  /// λₙ minus the tolerance, and |λₜ| minus the bound in the basis plus the tolerance: positive if
  /// closed, and if slipping.  Dimensionless.
  double closing(const Element& element, double t) const;
  double slipping(const Element& element, double t) const;

 private:
  const MultiplierSpace& multiplierSpace() const { return solved_.problem.multiplier(); }
  double closing(const Element& element, const MultiplierSpace::Value& stress) const;
  /// Arguments are dimensionless.
  double slipping(const Element& element, double shear, double bound) const;

  Solved solved_;
  bem::Units units_;
  const Vector& multiplier_;
  Vector bounds_;  ///< slip bounds as coefficients, in place of the tangential ones
  double tolerance_;
};

}  // namespace epafi::contact
