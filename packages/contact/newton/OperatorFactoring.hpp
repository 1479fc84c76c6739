#pragma once

#include "contact/newton/Factoring.hpp"

namespace epafi::contact {

/// By D's operator, which solves with D_II and lets coefficients at their bounds follow theirs;
/// held motions by the Schur complement of their responses.  Solutions are refined there.
///
/// Refers to the reduction.  \pre boundsFollowKnownRows(), D is not formed.
/// \throws SingularJacobian
std::unique_ptr<const Factoring> operatorFactoring(const Reduction& reduction);

}  // namespace epafi::contact
