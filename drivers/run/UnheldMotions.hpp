#pragma once

#include "contact/system/ContactSystem.hpp"
#include "drivers/run/BodySpaces.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// Checks that each free rigid motion of several bodies changes some contact; nothing
/// would resist others.  \throws bem::InputError naming the body and the motion
void checkResistance(const BodySpaces& spaces, const contact::ContactSystem& system);

/// "the load drives Bodies->pad in the direction (0, 1), a rigid motion in which neither
/// contact nor friction can balance it": the body that moves farthest in
/// contact::unresistedMotion, and what sides of bounded friction hold; of a body on flat ground "slides
/// ...: 5 > 0.3 x 10"; empty if there is none.
std::string unresisted(const BodySpaces& spaces, const contact::ContactSystem& system);

/// Those of some times at which multipliers of these meshes cannot balance the loads.
std::vector<double> unbalanced(const BodySpaces& spaces,
                               const std::vector<double>& times);

/// Both checks for the conditions at time t, without solving.
/// \throws bem::InputError for a body that nothing holds, or a load that neither contact
///   nor friction can balance
void checkUnheld(const BodySpaces& spaces,
                 const std::vector<contact::Conditions>& conditions, double t);

}  // namespace epafi::drivers
