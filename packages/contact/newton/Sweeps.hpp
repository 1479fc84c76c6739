#pragma once

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

/// A better start for active sets: λ after a few sweeps of the projected Gauss-Seidel
/// method, forward and backward in turn, each coefficient brought to its condition,
///
///   λ_i ← P(λ_i + r_i / D_ii),
///
/// slip bounds following at once; α stays.  A state carried over from a coarser mesh is
/// right but for short waves, at the ends of contact and of slip, and these are what
/// sweeps are good at.  Where D is not formed the start stays as it is.  Ends when a pair of sweeps changes no state, after ten pairs at the
/// latest.  A pair costs 4 n² operations; a Newton step costs up to n³/3.
Vector smoothed(const Equation& equation, Vector unknowns);

}  // namespace epafi::contact
