#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/moments/LegendreMoments.hpp"

namespace epafi::bem {

/// A boundary point seen from element e, accurate near a common vertex; exactly b = 0
/// when it lies on the element's own edge.
RelativeTarget seenFrom(const Mesh& mesh, int e, const BoundaryPoint& x);

/// The points of an element seen from another one, on its arc or a straight line of
/// targets: its ends and what half a length of it adds.
struct Sight {
  RelativeTarget start;
  RelativeTarget end;
  Complex step;
};
Sight sightOf(const Mesh& mesh, int outer, int inner);

}  // namespace epafi::bem
