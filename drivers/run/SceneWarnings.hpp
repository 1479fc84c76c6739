#pragma once

#include "drivers/scene/Scene.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// Warnings about a scene, one sentence each: data without effect, those of
/// findInConditions(), bodies that overlap deeply, polygons in place of curves in contact
/// (64 edges around a cylinder give 1.6 times the contact length of Hertz, since corners
/// touch first).
std::vector<std::string> warningsOf(const Scene& scene);

}  // namespace epafi::drivers
