#pragma once

#include "bem/compressed/ClusterTree.hpp"

#include <vector>

namespace epafi::bem {

/// Perimeter² over area: 4π for a disc, 16 for a square, 4 L for a beam of 1 : L, more for rings
/// and plates with many holes.
double slenderness(const Mesh& mesh);

/// An order of elements cut across where bodies are slender, so that what stands on both sides of
/// a beam, or about a place of a plate with many holes, is in one cluster before what is along
/// them: halved by unknowns, along the longer side of its box, until a slice is as stocky as
/// others. Within a slice the order and its stretches stay.
///
/// By the loop alone the two sides of a beam of length L and height 1 see each other everywhere,
/// and clusters keep unknowns in proportion to L.
/// \param places of the elements in the order, so that what must not be cut apart has one
std::vector<ClusterPlace> inSlices(const std::vector<const Space*>& spaces,
                                   const std::vector<ClusterPlace>& order,
                                   const std::vector<Vec2>& places);

}  // namespace epafi::bem
