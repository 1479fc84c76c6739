#pragma once

#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// Largest plausible overlap of bodies in contact: 5 % of the thickness of the thinner
/// elastic one (twice its area over the length of its outline); press fits have 1e-3
/// of it.  In the user's unit of length.
double largestInterference(const Scene& scene, const ContactPair& pair);

/// Checks that bodies overlap at their contacts only (interference), and that sides
/// beside a contact are not deeper in the other body than largestInterference.  Arcs
/// count as polygons of 32 edges.
/// \throws bem::InputError naming two bodies, their boundaries and a place that is inside
/// both.
void checkOverlaps(const Scene& scene);

}  // namespace epafi::drivers
