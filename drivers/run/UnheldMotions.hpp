#pragma once

#include "contact/system/ContactSystem.hpp"
#include "drivers/run/BodySpaces.hpp"

#include <string>

namespace epafi::drivers {

/// In a scene of several bodies every free rigid motion must move some contact: what leaves
/// all of them as they are, nothing resists and no load decides.
/// \throws bem::InputError naming the body.
void checkResistance(const Scene& scene, const contact::ContactSystem& system);

/// "the load drives Bodies->pad in the direction (0, 1), a rigid motion in which neither contact
/// nor friction can balance it": of contact::unresistedMotion, what moves the farthest; empty if
/// there is none.
std::string unresisted(const Scene& scene, const BodySpaces& spaces,
                       const contact::ContactSystem& system);

/// Both of a scene's conditions at a time, from geometry alone.
/// \throws bem::InputError naming a body that nothing holds, or that loads drive along a rigid motion
/// in which neither contact nor friction can balance them.
void checkBalance(const Scene& scene, const BodySpaces& spaces,
                  const std::vector<contact::Conditions>& conditions, double t);

}  // namespace epafi::drivers
