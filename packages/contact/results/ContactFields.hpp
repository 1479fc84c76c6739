#pragma once

#include "contact/results/Solved.hpp"

namespace epafi::contact {

enum class FrictionKind {
  None,  ///< the bound is zero: there is no friction to speak of
  Stick,
  Slip
};

/// What happens at a point of a contact boundary, in the user's units.  t is the outward
/// normal n turned counter-clockwise; λ = -σ(u) n.
struct ContactPoint {
  bem::Vec2 place;
  double pressure = 0;    ///< λₙ [stress]
  double shear = 0;       ///< λₜ [stress]
  double normal = 0;      ///< uₙ, relative to a body that is met [length]
  double tangential = 0;  ///< uₜ likewise [length]
  double sliding =
      0;           ///< how far what is met slid along t; slip is uₜ less this [length]
  double gap = 0;  ///< [length]
  double bound = 0;    ///< what the law lets |λₜ| be at this pressure [stress]
  double closing = 0;  ///< by how much the sides yield to the pressure [length]
  double worn = 0;     ///< depth [length]
  double distance =
      0;  ///< that the sides have slid while closed, forth and back [length]
  bool closed = false;  ///< λₙ > 0
  FrictionKind friction = FrictionKind::None;
};

/// The discrete solution as functions on the contact boundaries.
///
/// States follow the discrete inequalities: closed where λₙ > 0, slip where |λₜ| reaches
/// the bound as the multiplier's basis represents it, both within 1e-9 of the load.  Bonded
/// places are closed and stick, with an infinite bound.
/// Refers to its arguments, which must outlive it.
class ContactFields {
 public:
  explicit ContactFields(const Solved& solved);

  using Element = MultiplierSpace::ContactElement;
  const std::vector<Element>& elements() const { return multiplierSpace().elements(); }

  const Opposite& opposite() const { return solved_.problem.opposite(); }

  ContactPoint at(const Element& element, double t) const;

  /// λ without the jumps that no equation sees, see withoutJumps, for inUnits.
  Vector continuous() const;
  /// Such coefficients at a point.  [stress]
  MultiplierSpace::Value inUnits(const Vector& multiplier, const Element& element,
                                 double t) const;

  /// λ [stress] and uₜ [length] of at(), which costs more.
  MultiplierSpace::Value stress(const Element& element, double t) const;
  double slip(const Element& element, double t) const;

  /// λₙ, and how far |λₜ| is above the bound as the basis represents it, with the
  /// tolerance added in favour of "closed" being false and "slip" true: both change sign
  /// with the state.  Dimensionless.
  double closing(const Element& element, double t) const;
  double slipping(const Element& element, double t) const;

 private:
  const MultiplierSpace& multiplierSpace() const { return solved_.problem.multiplier(); }
  double closing(const Element& element, const MultiplierSpace::Value& stress) const;
  /// Of dimensionless numbers.
  double slipping(const Element& element, double shear, double bound) const;

  Solved solved_;
  bem::Units units_;
  const Vector& multiplier_;
  Vector bounds_;  ///< slip bounds as coefficients, in place of the tangential ones
  double tolerance_;
};

}  // namespace epafi::contact
