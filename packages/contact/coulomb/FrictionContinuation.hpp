#pragma once

#include "contact/tresca/Tresca.hpp"

namespace epafi::contact {

/// Follows the solution of Coulomb's problem from no friction to all of it:
///
///   θ s(λₙ),   q - (1 - θ) p,   θ = 0, ..., 1,   each solution the start of the next,
///
/// p the part of the resultant q that pressure alone cannot balance, so that there is a
/// beginning where only friction holds the body.  The report is not converged when the
/// path ends before θ = 1, as it does where `steps` linear systems have been solved; a
/// correction gets `patience` of them.
Solution followFriction(const Problem& problem, const Tresca& tresca, int steps,
                        int patience);

}  // namespace epafi::contact
