#pragma once

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

/// Improves a start x by symmetric sweeps of the projected Gauss-Seidel method,
///
///   λ_i ← P(λ_i + r_i / D_ii),
///
/// with current slip bounds; α stays.  A state from a coarser mesh has short-wave errors
/// at the ends of contact and of slip, which sweeps remove.  Ends when a pair of sweeps
/// changes no state, after at most ten pairs.  A pair takes 4 n² operations, a Newton
/// step up to n³/3. Returns x unchanged if D is not formed or x has converged.
Vector smoothed(const Equation& equation, Vector unknowns);

}  // namespace epafi::contact
