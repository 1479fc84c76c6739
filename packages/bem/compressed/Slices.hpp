#pragma once

#include "bem/compressed/ClusterTree.hpp"

#include <vector>

namespace epafi::bem {

/// Perimeter² over area: 4π for a disc, 16 for a square, 4 L for a beam of 1 : L, more for rings
/// and plates with many holes.
double slenderness(const Mesh& mesh);

/// Reorders elements of slender bodies into slices: each half of the unknowns across the longer
/// side of the bounding box, repeated until a slice is not slender.  Elements on both sides of a
/// beam, or around a part of a plate with many holes, then share a cluster.  Within a slice the
/// order and the stretches stay.
///
/// Without slices clusters follow the loop: those of the two sides of a beam of length L and
/// height 1 interact along all of it, and their skeletons grow like L.
/// \param places position of each element of `order`; elements to keep together have the same
std::vector<ClusterPlace> inSlices(const std::vector<const Space*>& spaces,
                                   const std::vector<ClusterPlace>& order,
                                   const std::vector<Vec2>& places);

}  // namespace epafi::bem
