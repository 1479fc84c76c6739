#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/moments/LegendreMoments.hpp"

namespace epafi::bem {

/// A boundary point seen from element e, accurate near a common vertex; exactly b = 0
/// when it lies on the element's own edge.
RelativeTarget seenFrom(const Mesh& mesh, int e, const BoundaryPoint& x);

}  // namespace epafi::bem
