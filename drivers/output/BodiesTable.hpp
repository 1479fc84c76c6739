#pragma once

#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// bodies.csv: per level, step of a path (else 0) and body the resultants of loads, contact
/// and what holds it, which add up to nothing, and its motion: of a body that deforms the
/// mean over its boundary, of another one that of its reference point.
std::string bodiesHead();
std::string bodiesLines(const Scene& scene, int level, int step,
                        const std::vector<contact::Summary>& bodies,
                        const std::vector<RigidRow>& rigid);

}  // namespace epafi::drivers
