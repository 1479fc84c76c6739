#pragma once

#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// Bodies may lie in one another only where they are in contact: there it is interference.
/// Arcs count as polygons of 32 edges.
/// \throws bem::InputError naming two bodies and a place that is inside both.
void checkOverlaps(const Scene& scene);

}  // namespace epafi::drivers
