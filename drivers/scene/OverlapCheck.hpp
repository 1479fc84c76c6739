#pragma once

#include "drivers/scene/Scene.hpp"

namespace epafi::drivers {

/// Largest plausible interference of two bodies in contact [length]: 5 % of the thickness
/// of the thinner elastic one (twice its area over the length of its outline).  Press
/// fits have about 0.1 %.
double largestInterference(const Scene& scene, const ContactPair& pair);

/// Checks that bodies overlap only at their contacts, and that boundaries beside a
/// contact overlap by at most largestInterference.  Arcs are replaced by 32 chords.
/// \throws bem::InputError with the two bodies, their boundaries and a point inside both.
void checkOverlaps(const Scene& scene);

}  // namespace epafi::drivers
