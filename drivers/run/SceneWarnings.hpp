#pragma once

#include "drivers/scene/Scene.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// What is probably not meant in a scene, a sentence each: what has no effect, displacements
/// that jump at a corner or go through an obstacle there, loads narrower than their elements
/// can see, bodies drawn deep into each other, straight edges that draw a curve on a side in contact.  A polygon meets an obstacle
/// at its corners: 64 edges around a cylinder give 1.6 times Hertz' contact length.
std::vector<std::string> warningsOf(const Scene& scene);

}  // namespace epafi::drivers
