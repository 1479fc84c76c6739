#pragma once

#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// Beyond this bodies in contact are drawn wrong rather than pressed into each other: 5 % of the
/// thinner elastic one's thickness (twice its area over the length of its outline); press fits have 0.1 % or so.  In the user's unit of length.
double largestInterference(const Scene& scene, const ContactPair& pair);

/// Bodies may lie in one another only where they are in contact: there it is interference.
/// Sides beside a contact may reach as deep as one; arcs count as polygons of 32 edges.
/// \throws bem::InputError naming two bodies, their boundaries and a place that is inside both.
void checkOverlaps(const Scene& scene);

}  // namespace epafi::drivers
