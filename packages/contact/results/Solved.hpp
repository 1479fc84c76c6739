#pragma once

#include "contact/opposite/Opposite.hpp"
#include "contact/system/ContactBody.hpp"
#include "contact/system/Wear.hpp"

namespace epafi::contact {

/// The solution of a body and the data from which results are computed.
struct Solved {
  const bem::Space& space;
  const ContactBody& problem;
  const Conditions& conditions;
  bem::Units units;
  const State& state;          ///< of all bodies
  const Vector& displacement;  ///< all unknowns, dimensionless
  /// See ContactBody::displacement.
  Vector contactForce = problem.contactForce(state.multiplier);
  ContactBody::Results results = problem.results(state, displacement, contactForce);
  const Motions* motions = nullptr;  ///< of all bodies; null: opposite sides are fixed
  /// In a step of a path the displacement of the previous step, from which slip is measured;
  /// else null, and slip is measured from zero.
  const bem::DisplacementField* displacementBefore = nullptr;
  const Motions* motionsBefore = nullptr;        ///< of all bodies, previous step
  const State* stateBefore = nullptr;            ///< previous step; null: zero
  const Conditions* conditionsBefore = nullptr;  ///< previous step; null: none
  const Wear* wear = nullptr;                    ///< after a step of a path; else null
  bem::DisplacementField field{space, displacement};  ///< without the particular solution

  /// u including the particular solution, dimensionless.
  bem::Vec2 displacementAt(int element, double t) const {
    return whole(field, conditions.inside, element, t);
  }
  /// Particular solution of the previous step.
  BodyLoadSolution insideBefore() const {
    return conditionsBefore == nullptr ? nullptr : conditionsBefore->inside;
  }
  /// displacementAt of the previous step; zero without one.
  bem::Vec2 displacementBeforeAt(int element, double t) const {
    return displacementBefore == nullptr
               ? bem::Vec2{}
               : whole(*displacementBefore, insideBefore(), element, t);
  }

 private:
  bem::Vec2 whole(const bem::DisplacementField& u, const BodyLoadSolution& inside,
                  int element, double t) const {
    const bem::Vec2 own = u.at(element, t);
    return inside ? own + inside->displacement(space.mesh(), element, t) : own;
  }
};

/// State of a point of a contact boundary, in the user's units.  Normal is along the direction d of
/// contact, see Opposite, tangential along d turned counter-clockwise; λ = -σ(u) n.
struct ContactPoint {
  bem::SurfacePoint place;
  Direction direction;    ///< d, dimensionless
  double pressure = 0;    ///< λₙ [stress]
  double shear = 0;       ///< λₜ [stress]
  double normal = 0;      ///< uₙ, relative to the opposite side [length]
  double tangential = 0;  ///< uₜ, relative to the opposite side [length]
  double sliding = 0;   ///< given, of the opposite side; slip is uₜ - sliding [length]
  double gap = 0;       ///< [length]
  double bound = 0;     ///< slip bound s(λₙ) [stress]
  double closing = 0;   ///< normal compliance φ(λₙ) of the surfaces [length]
  double worn = 0;      ///< worn depth [length]
  double distance = 0;  ///< Σ |slip| while closed [length]
  bool closed = false;  ///< λₙ > 0
  ContactState friction = ContactState::Frictionless;
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
  const std::vector<Element>& elements() const { return solved_.problem.elements(); }

  ContactPoint at(const Element& element, double t) const;

  /// Coefficients of λ without arbitrary jumps, see withoutJumps.
  Vector continuous() const;
  /// Value of a multiplier, given by coefficients, at a point [stress].
  MultiplierSpace::Value inUnits(const Vector& multiplier, const Element& element,
                                 double t) const;

  /// λ [stress] as in at(), at less cost.
  MultiplierSpace::Value stress(const Element& element, double t) const {
    return inUnits(multiplier_, element, t);
  }

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
