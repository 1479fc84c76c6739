#pragma once

#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// What is probably not meant in a solved level, a sentence each: nothing is loaded, or by less
/// than numbers can tell, contact never closes, sliding beyond a tenth of the length in contact,
/// displacements beyond a tenth of a body: conditions on the undeformed outline mean little
/// there.  What rounding has taken: bodies out of balance, conditions of contact that the
/// displacements do not meet.
std::vector<std::string> warningsOf(const Scene& scene, const SolvedLevel& level);

}  // namespace epafi::drivers
