#pragma once

#include "drivers/run/SolvedBodies.hpp"

#include <vector>

namespace epafi::drivers {

/// Estimates the error of some states on one mesh: the steps of a path, or one load.
///
/// Sets the level's indicators, of each element those of the state in which they are largest,
/// and its relative estimate.  Collective.
/// \param strainEnergies of each state, in the user's units
/// \returns the error estimate of each state
bem::Vector estimateErrors(const Ground& ground,
                           const std::vector<const SolvedBodies*>& states,
                           const bem::Vector& strainEnergies, Level& level);

}  // namespace epafi::drivers
