#pragma once

#include "adaptivity/singular/SingularPoints.hpp"
#include "contact/opposite/Opposite.hpp"

namespace epafi::adaptivity {

/// A state of a body: a step of a path, or all of a load at once.
struct SolvedStep {
  const contact::ContactState& states;
  const bem::Vector& displacement;
  const contact::Motions* motions = nullptr;  ///< of what it meets; null: stands still
  /// Before the step; null: nothing had moved.
  const bem::Vector* displacementBefore = nullptr;
  const contact::Motions* motionsBefore = nullptr;
};

/// A place on an edge of the outline where contact or friction changes its state.
struct Transition {
  int edge = 0;
  double place = 0;  ///< distance from the edge's start [outline diameters]
};

/// Where the states change, as well as the solution tells.
struct LocatedTransitions {
  std::vector<Transition> transitions;
  /// The singular points of the conditions, and the changes of state that belong to none
  /// of the transitions.
  SingularPoints others;
};

/// Finds the ends of contact and of stick by the solution's structure.
///
/// Next to the end of contact the gap opens like d^(3/2), next to the end of stick the
/// slip of the step grows like d^(3/2), d the distance from it, times functions that are
/// analytic in d.  So the power 2/3 of the displacement is fitted by a parabola, least squares over
/// up to three elements of the side that moves, and the parabola's zero is the place.
/// The displacement is used because the multiplier, which falls like d^(1/2) on the other
/// side, oscillates there.
///
/// A run of a state on at most three coefficients' places of one edge, within one element
/// or two neighbours, is taken for a flicker: the changes around it belong together, and
/// are one transition if their number is odd, none if it is even.  The ends of a held
/// zone on one or two elements are not looked for: such a zone may be what the mesh makes
/// of a jump.  A place outside the elements in which the states change is not believed:
/// then they stay with `others`, as do changes between the two directions of slip.
///
/// `opposite`: what the contact sides meet.
LocatedTransitions locateTransitions(const bem::Space& space,
                                     const contact::Conditions& conditions,
                                     const contact::MultiplierSpace& multiplier,
                                     const contact::Opposite& opposite,
                                     const SolvedStep& step);

/// All of them as singular points of a mesh, which may differ from the one they were
/// found on by moved nodes: a transition less than one percent of an element away from a
/// node is at the node.
SingularPoints placeOn(const bem::Mesh& mesh, const LocatedTransitions& located);

}  // namespace epafi::adaptivity
