#pragma once

#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// At ν = 1/2 in plane strain and on solids of revolution the kernel of V contains the normal field of
/// each closed line. Form Density removes it on lines with contact elements; on other lines this pins
/// ψ on the longest edge of known traction, see contact::Conditions::pins.
/// \throws InputError for another form, and for a line without such an edge.
void pinIncompressible(std::size_t b, Scene& scene);

}  // namespace epafi::drivers
