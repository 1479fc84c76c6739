#pragma once

#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// Warnings about a solved level, one sentence each: no loads or loads of the size of
/// rounding errors, contact that never closes, sliding beyond a tenth of the contact
/// length, displacements beyond a tenth of a body (the model is for small ones); by
/// rounding errors: bodies out of balance, contact conditions that the displacements
/// violate.
std::vector<std::string> warningsOf(const Scene& scene, const SolvedLevel& level);

}  // namespace epafi::drivers
