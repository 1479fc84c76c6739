#pragma once

#include "bem/base/Processes.hpp"
#include "contact/system/ContactSystem.hpp"

namespace epafi::contact {

/// Defect correction of a solution, so that the displacements satisfy the contact conditions.
///
/// The condensed problem satisfies them with D λ and d₀, which are as large as the displacements
/// of bodies without contact.  The displacement of a slender body held by contact is a small
/// difference of both, and errors by rounding or compression have the size of D: 5e-2 of the
/// displacement of a compressed beam of 1 : 100.  Therefore Newton steps follow, with D in the
/// Jacobian,
///
///   J d = -F(λ, C u - M λ - g),   u = A⁺ (f - Cᵀ λ),
///
/// if r exceeds 1e-10 of the deformation, until it is 1e-12 or a step reduces it by less than 10
/// (as many steps more as beddings stand on each other, through which corrections pass one by one).
/// The forces f - Cᵀ λ are small where they balance, so that u is accurate.  Intermediate states
/// with F above 1e-8 of the load are never the result.
///                                                 [doc/theory/contact.md, Defect correction]
///
/// Collective.  Returns the given solution if no step improves it.  \pre it has converged
Configuration corrected(const ContactSystem& system, State state,
                        const bem::Processes& processes);

}  // namespace epafi::contact
