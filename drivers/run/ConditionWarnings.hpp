#pragma once

#include "drivers/scene/Scene.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// Adds what boundary conditions say that is probably not meant, at the end of a path and at some
/// times before it, each sentence once: displacements that jump at a corner or go through an obstacle
/// there, loads narrower than their elements can see.
void findInConditions(const Scene& scene, std::vector<std::string>& warnings);

}  // namespace epafi::drivers
