#pragma once

#include "adaptivity/refine/Refine.hpp"
#include "drivers/run/Level.hpp"

#include <vector>

namespace epafi::drivers {

// What discretisation leaves of singular stresses in the others cancels between both bodies, if their
// elements are the same.                  [doc/theory/estimators.md, Several bodies]

/// Where a bond ends and contact begins, with the nodes and degrees of both sides on each.
std::vector<std::vector<bem::Piece>> matchedAtBonds(
    const Scene& scene, std::vector<std::vector<bem::Piece>> meshes);

/// Adds to the marked elements of all bodies those opposite with the same nodes.
/// \param worst ascending, by body
void shareMarked(const Scene& scene, const std::vector<const bem::Mesh*>& meshes,
                 std::vector<std::vector<int>>& worst);
/// Gives such elements the stronger of both marks; where degrees differ the lower is raised.
void shareMarks(const Scene& scene, const std::vector<const bem::Mesh*>& meshes,
                std::vector<adaptivity::Marks>& marks);

}  // namespace epafi::drivers
