#pragma once

#include "contact/opposite/Opposite.hpp"
#include "contact/system/ContactBody.hpp"
#include "contact/system/Wear.hpp"

namespace epafi::contact {

struct Solved;

/// Tractions on a body by multipliers of other bodies, dimensionless.
class ForeignPressure {
 public:
  ForeignPressure() = default;
  /// Tractions on body b.  Refers to the bodies.
  ForeignPressure(std::size_t b, const std::vector<Solved>& bodies);

  bem::Vec2 at(int element, double t) const;
  /// Jumps inside an element, in [-1, 1], unsorted.
  Vector breaks(int element) const;

 private:
  std::vector<const Solved*> carriers_;
  int body_ = -1;
};

/// The solution of a body and the data from which results are computed.
struct Solved {
  const bem::Space& space;
  const ContactBody& problem;
  const Conditions& conditions;
  bem::Units units;
  const State& state;          ///< multiplier and rigid motions of this body
  const Vector& displacement;  ///< all unknowns, dimensionless
  /// See ContactBody::displacement; that of its own multiplier, if none is given.
  Vector contactForce = problem.contactForce(state.multiplier);
  ForeignPressure pressed{};
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

  /// [u] = u - u of the opposite point, dimensionless.
  bem::Vec2 relativeDisplacement(const MultiplierSpace::ContactElement& element, double t,
                                 const Opposite::Point& opposite) const {
    return displacementAt(element.element, t) - motionAt(motions, opposite);
  }

 private:
  bem::Vec2 whole(const bem::DisplacementField& u, const BodyLoadSolution& inside,
                  int element, double t) const {
    const bem::Vec2 own = u.at(element, t);
    return inside ? own + inside->displacement(space.mesh(), element, t) : own;
  }
};

}  // namespace epafi::contact
