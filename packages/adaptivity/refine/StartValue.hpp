#pragma once

#include "contact/multiplier/MultiplierSpace.hpp"
#include "contact/problem/Problem.hpp"

namespace epafi::adaptivity {

/// Interpolates a multiplier on other meshes of the same outlines, at the Gauss points of
/// its contact elements.
///
/// Exact if each new element lies in one old element and has at least its degree, except
/// for bases that share nodes: a common coefficient is the mean of two.
/// \throws bem::NumericalError if the new meshes have contact where the old ones have none
contact::Vector carryMultiplier(const contact::MultiplierSpace& from,
                                const contact::Vector& multiplier,
                                const contact::MultiplierSpace& to);

/// Transfers a state to other meshes of the same outlines: λ by carryMultiplier(), α
/// unchanged.  The new coefficients of λ may violate the contact conditions; Newton's
/// first step corrects that. An empty state stays empty.
contact::State carry(const contact::MultiplierSpace& from, const contact::State& state,
                     const contact::MultiplierSpace& to);

}  // namespace epafi::adaptivity
