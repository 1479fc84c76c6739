#pragma once

#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// At ν = 1/2 in plane strain, V has the normals of each closed line of a body in its kernel.
/// What Form Density adds on contact elements takes them out; on other lines this pins ψ on
/// the longest edge without load, see contact::Conditions::pins.
/// \throws bem::InputError for another form, and for a line without such an edge.
void pinIncompressible(Scene& scene);

}  // namespace epafi::drivers
