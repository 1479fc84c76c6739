#pragma once

#include "bem/moments/ElementRuns.hpp"
#include "bem/moments/Tile.hpp"

namespace epafi::bem {

/// Far moments of E and the elements of `far`, by tensor Gauss quadrature with far.smooth; all
/// lanes are written.  Between segments with one reciprocal per pair of points and one logarithm
/// per outer point: ∫ P_j log|w| follows from ∫ P_j w·τ/|w|² by parts.  With arcs points and normals
/// are on the curves, and there is a logarithm per pair of points.
void farMoments(const Element& e, const ElementLanes& far, Tile& moments);

}  // namespace epafi::bem
