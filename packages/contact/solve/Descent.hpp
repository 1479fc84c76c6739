#pragma once

#include "contact/solve/Equation.hpp"

namespace epafi::contact {

/// P(x) onto the box of a problem; slip bounds are taken at P(λₙ), α is kept.
Vector projectOntoBox(const Problem& problem, Vector unknowns);

/// Bertsekas' direction for the energy over the box, at a point of the box.
///
/// Coefficients within ε of a bound that the gradient pushes against move along their own
/// gradient, c r; the others solve D_FF d = r_F.  ε shrinks with the residual, which
/// keeps the arc P(λ + t d) one of descent for small t > 0. [Bertsekas 1982] \pre no
/// rigid motions, bounds that do not depend on the pressure
Vector projectedNewtonStep(const Equation& equation, const Evaluation& at);

/// Newton's direction for F = 0, or minus the scaled gradient of ½|F|² where Newton's is
/// none of descent.
Vector meritDescentStep(const Equation& equation, const Evaluation& at);

}  // namespace epafi::contact
