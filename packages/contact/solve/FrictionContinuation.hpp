#pragma once

#include "contact/solve/CoulombIteration.hpp"

namespace epafi::contact {

/// Follows the solution of Coulomb's problem from no friction to all of it:
///
///   strengths θ f,  θ = 0, ..., 1,  each solution the start of the next.
///
/// Steps in θ grow after success and shrink after failure.  The report tells all Newton
/// steps together; it is not converged when the path ends before θ = 1, or has no
/// beginning because only friction holds the body.
Solution followFriction(const Problem& problem, const SolverOptions& options);

}  // namespace epafi::contact
