#pragma once

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

/// What an interior point method found.
struct InteriorPoint {
  Vector unknowns;     ///< x = (λ, α), λ strictly inside the box
  int iterations = 0;  ///< linear systems factorised
};

/// Mehrotra's predictor-corrector method for the quadratic programme behind a problem
/// with fixed slip bounds,
///
///   min ½ λᵀDλ - d₀ᵀλ   over the box,   Gᵀλ = q,
///
/// started in the middle of the box.  Its number of steps hardly depends on the size or
/// the condition of D, where active sets move by a coefficient a step: thin bodies, whose
/// pressure is all at the rims of contact.  It ends when complementarity is so small that
/// Newton's method has only digits to add, or when no step leads on.  [Mehrotra 1992]
/// \pre the equation's bounds do not depend on the pressure
InteriorPoint interiorPoint(const Equation& equation, int maximumSteps = 100);

}  // namespace epafi::contact
