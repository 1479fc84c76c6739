#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/moments/Tile.hpp"
#include "bem/quadrature/Graded.hpp"

namespace epafi::bem {

/// Writes the moments of a near pair (equal, touching or closer than half the larger length) to one
/// lane; other lanes stay as they are.  Potential of the larger element in closed form, at points
/// of the smaller one that are graded toward the projections of the end points of the larger one,
/// where its potential has logarithms.                 [doc/theory/operators.md]
void nearMoments(const Mesh& mesh, int e, int f, Tile& moments, int lane);

/// The same with a given rule on the smaller element, also for an element with itself.
void nearMoments(const Mesh& mesh, int e, int f, const GradedRule& rule, Tile& moments,
                 int lane);

}  // namespace epafi::bem
