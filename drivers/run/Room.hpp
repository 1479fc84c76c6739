#pragma once

#include "drivers/run/BodySpaces.hpp"

namespace epafi::drivers {

/// Checks that bodies of plane strain and Poisson's Ratio 1/2, on which contact with obstacles and
/// prescribed displacements act all around, keep their area: obstacles that leave less room
/// than that cannot be met.  Bodies with body loads are not looked at.
/// \throws bem::InputError naming the body
void checkRoom(const BodySpaces& spaces, double t);

}  // namespace epafi::drivers
