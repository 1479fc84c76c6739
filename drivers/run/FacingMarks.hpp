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

/// What refinement of one side of a contact between elastic bodies means for the other, from
/// those of all.                                     [doc/theory/estimators.md, Strategies]

/// Where contact or friction changes its state on one side it does so on the other, and where
/// either ends: singular points of both.
void shareSingularPoints(const Scene& scene, std::vector<SingularMesh>& meshes);

/// The elements of all bodies that are to be refined, and those that face them beside strong
/// singular points unless they are less than half as long: graded apart, each side's
/// pressure follows what the other one cannot.
std::vector<std::vector<int>> withFacing(const Scene& scene,
                                         const std::vector<SingularMesh>& meshes,
                                         std::vector<std::vector<int>> worst);

}  // namespace epafi::drivers
