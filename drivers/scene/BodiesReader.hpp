#pragma once

#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// Reads the bodies of a scene whose file, constants and validated list are set.
///
/// All elastic bodies are scaled by the length of the largest and the Young's modulus of
/// the softest.  Rigid bodies do not count: they must not change the results of others.
/// \throws bem::InputError for a rigid body with keys of elastic ones or vice versa, if
///   no body is elastic, and as readLoops, readConditions and readMesh.
void readBodies(Scene& scene);

}  // namespace epafi::drivers
