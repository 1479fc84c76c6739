#pragma once

#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// Reads the bodies of a scene that has its file, constants and validated list.
///
/// Elastic bodies share one length, that of the largest, and one stress, that of the
/// softest.  Rigid ones do not count: they must not change what the others do.
/// \throws bem::InputError for a rigid body with what elastic ones have or the other way
///   round, no elastic body, and what readLoops, readConditions, readMesh refuse.
void readBodies(Scene& scene);

}  // namespace epafi::drivers
