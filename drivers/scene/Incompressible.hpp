#pragma once

#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// At ν = 1/2 in plane strain, the normals of each closed line of a body are in the null
/// space of V.  Form Density removes them on lines with contact; on others this adds a pin
/// of ψ on the longest edge without load, see contact::Conditions::pins.
/// \throws bem::InputError for another form, and for a line without such an edge.
void pinIncompressible(Scene& scene);

}  // namespace epafi::drivers
