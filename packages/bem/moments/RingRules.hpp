#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/simd/ComplexPack.hpp"

#include <vector>

namespace epafi::bem {

/// Eight quadrature points (t, s) of a pair of elements E and F of a solid of revolution.
struct alignas(64) RingPoints {
  AlignedLane t;       ///< on E
  AlignedLane s;       ///< on F
  AlignedLane weight;  ///< unused lanes: 0
  ComplexLanes w;      ///< x - y, without cancellation
};

/// Points for two elements that are the same, touch, or are close to each other, for the kernels of
/// RingKernels times polynomials of the elements' degrees; error 1e-14 of the norm.
///
/// Logarithms and poles where the elements meet are softened by the seventh power of the distance,
/// in both orders of x and y on one element, in both triangles behind a common node.  Elements that
/// are long beside their neighbour, or beside their distance from the axis, where the image of x
/// behind the axis is singular, too, are halved.  Neither on the axis.
/// \param more  in addition to the degrees
// NOLINTNEXTLINE(readability-function-*): the pair, how, where
void nearRingPoints(const Mesh& mesh, int e, int f, int more,
                    std::vector<RingPoints>& to);

}  // namespace epafi::bem
