#pragma once

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

/// What an interior point method found.
struct InteriorPoint {
  Vector unknowns;      ///< x = (λ, α), strictly inside
  int iterations = 0;   ///< linear systems factorised
  bool jammed = false;  ///< steps became too short to lead anywhere
};

/// How much of the predictor's second order its corrector takes.
enum class SecondOrder {
  /// As much as the predictor reaches: one that does not reach far says little of second order,
  /// and with all of it steps stay short and lead in circles.      [Colombo, Gondzio 2008]
  ByReach,
  Full  ///< Mehrotra's own
};

/// Mehrotra's predictor-corrector method for all laws of friction.  Distances a from the
/// bounds and the forces z that keep them are unknowns of their own,
///
///   a = λₙ,  a± = s(λₙ) ∓ λₜ,   rₙ + z = 0,  rₜ = z₊ - z₋,   c a z = μ -> 0,
///
/// started in the middle.  With fixed bounds it solves a convex quadratic programme; a bound
/// that follows the pressure is differentiated.  Its number of steps hardly depends on the
/// size or the condition of D, where active sets move by a coefficient a step: thin bodies.
/// Ends when the equation is solved, or when no step leads on.                [Mehrotra 1992]
InteriorPoint interiorPoint(const Equation& equation,
                            SecondOrder order = SecondOrder::ByReach,
                            int maximumSteps = 100);

}  // namespace epafi::contact
