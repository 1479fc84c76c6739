#pragma once

#include "contact/equation/Equilibrium.hpp"
#include "contact/solve/Report.hpp"
#include "contact/system/ContactSystem.hpp"
#include "drivers/run/BodySpaces.hpp"

#include <string>

namespace epafi::drivers {

/// Why a solve did not converge and what in the scene might help; empty if it did.
std::string reasonOf(const contact::Report& report, const Scene& scene);

/// Message for a load that nothing balances, with the motion of unresisted() if there is
/// one, and advice.
std::string withAdvice(const contact::NoBalance& error, const std::string& unresisted);

/// "; contact points that still change state: (0.31, 0) on foundation, ...", at most
/// five; empty if there are none.
std::string changingPlaces(const contact::Report& report,
                           const contact::ContactSystem& system,
                           const BodySpaces& spaces);

}  // namespace epafi::drivers
