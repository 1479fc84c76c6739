#pragma once

#include "contact/system/ContactSystem.hpp"
#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// In a scene of several bodies every free rigid motion must move some contact: what leaves
/// all of them as they are, nothing resists and no load decides.
/// \throws bem::InputError naming the body.
void checkResistance(const Scene& scene, const contact::ContactSystem& system);

}  // namespace epafi::drivers
