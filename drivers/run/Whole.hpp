#pragma once

#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// Results of the whole scene from those of the half (Geometry->Symmetry): twice the
/// components along the line, zero across it and for moments.  Without symmetry
/// unchanged.
contact::Summary wholeOf(const Symmetry& symmetry, contact::Summary half);

/// The same for one body, if the line cuts it; else unchanged.
contact::Summary wholeOf(const Symmetry& symmetry, const bem::Outline& outline,
                         const contact::Summary& drawn);
std::vector<contact::Summary> wholeBodies(const Scene& scene,
                                          std::vector<contact::Summary> drawn);
RigidRow wholeOf(const Symmetry& symmetry, const bem::Outline& outline, RigidRow drawn);

}  // namespace epafi::drivers
