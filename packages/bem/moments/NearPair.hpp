#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/moments/PairMoments.hpp"

namespace epafi::bem {

/// Moments of two elements that coincide, touch or lie closer than half the larger one's
/// length: closed form inside, outside a rule graded toward the feet of the inner
/// element's end points, where its potential has logarithms. [design.md 3.4]
void nearPairMoments(const Mesh& mesh, int e, int f, PairMoments& moments);

}  // namespace epafi::bem
