#pragma once

#include "contact/opposite/Opposite.hpp"
#include "contact/system/ContactProblem.hpp"
#include "contact/system/Wear.hpp"

namespace epafi::contact {

struct Solved;

/// Tractions on a body that come from other bodies' multipliers, dimensionless.
class ForeignPressure {
 public:
  ForeignPressure() = default;
  /// On body b among all of them, which must outlive it.
  ForeignPressure(std::size_t b, const std::vector<Solved>& bodies);

  bem::Vec2 at(int element, double t) const;
  /// Where it jumps inside an element, within [-1, 1], in any order.
  Vector breaks(int element) const;

 private:
  std::vector<const Solved*> carriers_;
  int body_ = -1;
};

/// Everything that the results of a body are computed from.
struct Solved {
  const bem::Space& space;
  const bem::SteklovPoincare& stiffness;
  const ContactProblem& problem;
  const Conditions& conditions;
  bem::Units units;
  const State& state;          ///< of the body's own multiplier and rigid motions
  const Vector& displacement;  ///< all unknowns, dimensionless
  Vector met{};                ///< see ContactProblem::displacement
  ForeignPressure pressed{};
  const Motions* motions = nullptr;  ///< of all bodies; null: what is met does not deform
  /// The displacement of the step before in a step of a path, friction counts slip from
  /// there; else null, and slip counts from zero.
  const Vector* displacementBefore = nullptr;
  const Motions* motionsBefore = nullptr;        ///< likewise of all bodies
  const State* stateBefore = nullptr;            ///< likewise; null: nothing acted
  const Conditions* conditionsBefore = nullptr;  ///< likewise; null: there were none
  const Wear* wear = nullptr;                    ///< behind a step of a path; else null

  /// u, the particular solution's included, dimensionless.
  bem::Vec2 displacementAt(int element, double t) const {
    return whole(displacement, conditions.inside, element, t);
  }
  /// What acted inside in the step before.
  Inside insideBefore() const {
    return conditionsBefore == nullptr ? nullptr : conditionsBefore->inside;
  }
  /// That of the step before, zero without one.
  bem::Vec2 displacementBeforeAt(int element, double t) const {
    return displacementBefore == nullptr
               ? bem::Vec2{}
               : whole(*displacementBefore, insideBefore(), element, t);
  }

  /// [u] = u - u of what is met, dimensionless.
  bem::Vec2 relativeDisplacement(const MultiplierSpace::ContactElement& element, double t,
                                 const Opposite::Point& opposite) const {
    return displacementAt(element.element, t) - motionAt(motions, opposite);
  }

 private:
  bem::Vec2 whole(const Vector& u, const Inside& inside, int element, double t) const {
    const bem::Vec2 own = space.displacementAt(u, element, t);
    return inside ? own + inside->displacement(space.mesh(), element, t) : own;
  }
};

}  // namespace epafi::contact
