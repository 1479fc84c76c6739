#pragma once

#include "bem/base/Processes.hpp"
#include "contact/system/ContactSystem.hpp"

namespace epafi::contact {

/// What a solution means for its bodies, once its displacements meet the conditions of contact
/// by themselves.
///
/// A solution meets them by D λ and d₀, each as large as the bodies bend alone. Where contact
/// holds a slender body its displacement is a small difference of the two, and what rounds in
/// them, or is left out in compressed operators, has the size of D: 5e-2 of the displacement of
/// a compressed beam of 1 : 100. Steps of Newton's method therefore follow, with D for its
/// derivative,
///
///   J d = -F(λ, C u - M λ - g),   u = A⁺ (f - Cᵀ λ),
///
/// where r is above 1e-10 of the displacement, down to 1e-12 or as long as it falls to a tenth;
/// forces f - Cᵀ λ are in balance place by place, so that u has its digits.  A state that is no solution, F above 1e-8
/// of the load, is passed through and never the result.
///                                                 [doc/theory/contact.md, Defect correction]
///
/// Collective.  \pre the solution has converged: it is the result where nothing better is found.
Configuration corrected(const ContactSystem& system, State state,
                        const bem::Processes& processes);

}  // namespace epafi::contact
