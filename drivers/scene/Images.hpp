#pragma once

#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// The corners of all bodies where a roller makes what meets it there, load and contact included,
/// go on as its mirror image: Conditions::images, by body.  Nothing is singular there.
std::vector<std::set<int>> imageCorners(const Scene& scene);

}  // namespace epafi::drivers
