#pragma once

#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// What is probably not meant, a sentence each: what has no effect, displacements that jump at
/// a corner, straight edges that draw a curve on a side in contact.  A polygon meets an obstacle
/// at its corners: 64 edges around a cylinder give 1.6 times Hertz' contact length.
std::vector<std::string> warningsOf(const Scene& scene);

/// The same of a solved level: nothing is loaded, contact never closes, sliding beyond a tenth of
/// the length in contact, displacements beyond a tenth of a body: conditions on the undeformed
/// outline mean little there.
std::vector<std::string> warningsOf(const Scene& scene, const SolvedLevel& level);

}  // namespace epafi::drivers
