#pragma once

#include "bem/base/Processes.hpp"
#include "contact/solve/Report.hpp"
#include "contact/system/ContactSystem.hpp"

#include <functional>

namespace epafi::contact {

/// What a step comes to.
struct Settled {
  Solution solution;      ///< with the reports of all solves
  Configuration at{};     ///< corrected, and worn; only if it has converged
  double wearChange = 0;  ///< where wear does not settle, its last change
};

/// Solves a step as the program does: again and again, each time from the state before, until the
/// slip settles by which sides wear, see ContactSystem::wearBy; then corrected() and worn().
///
/// Collective.  \param solve  from the state before, null at first
Settled settled(ContactSystem& system,
                const std::function<Solution(const State* before)>& solve,
                const bem::Processes& processes);

/// A solution with the wear by its slips, which the system then has.
Configuration worn(ContactSystem& system, Configuration at);

}  // namespace epafi::contact
