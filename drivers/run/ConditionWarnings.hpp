#pragma once

#include "drivers/scene/Scene.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// Adds warnings about boundary conditions, at the end of a path and at some times
/// before, each once: displacements that jump at a corner or penetrate an obstacle there,
/// loads on parts of the boundary that are too short for the mesh.
void findInConditions(const Scene& scene, std::vector<std::string>& warnings);

}  // namespace epafi::drivers
