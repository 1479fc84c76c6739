#pragma once

#include "adaptivity/mark/Strategy.hpp"
#include "drivers/scene/Scene.hpp"

#include <vector>

namespace epafi::drivers {

/// A body's mesh and its singular points.  Refers to the mesh.
struct SingularMesh {
  const bem::Mesh& mesh;
  adaptivity::SingularPoints singular;
};

/// Refinement of opposite sides of contacts between elastic bodies.
///                                              [doc/theory/estimators.md, Several bodies]

/// Adds to each side of a contact the singular points opposite: transitions, and the ends
/// of the other side.
void shareSingularPoints(const Scene& scene, std::vector<SingularMesh>& meshes);

/// The marked elements of all bodies, and for those beside a strong singular point the
/// opposite elements, unless less than half as long, so that both sides are graded alike.
/// \param worst marked elements, by body
std::vector<std::vector<int>> withFacing(const Scene& scene,
                                         const std::vector<SingularMesh>& meshes,
                                         std::vector<std::vector<int>> worst);

}  // namespace epafi::drivers
