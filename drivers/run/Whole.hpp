#pragma once

#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// What results of one half are of the whole (Geometry->Symmetry): twice those along the line, none
/// across it or turning; without symmetry the same.
contact::Summary wholeOf(const Symmetry& symmetry, contact::Summary half);

/// Of bodies that the line cuts those of the whole body; of others the same.
contact::Summary wholeOf(const Symmetry& symmetry, const bem::Outline& outline,
                         const contact::Summary& drawn);
std::vector<contact::Summary> wholeBodies(const Scene& scene,
                                          std::vector<contact::Summary> drawn);
RigidRow wholeOf(const Symmetry& symmetry, const bem::Outline& outline, RigidRow drawn);

}  // namespace epafi::drivers
