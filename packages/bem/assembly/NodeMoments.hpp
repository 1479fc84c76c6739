#pragma once

#include "bem/assembly/FarPairs.hpp"
#include "bem/potential/LegendreMoments.hpp"
#include "bem/space/Space.hpp"

#include <vector>

namespace epafi::bem {

/// ∫ P_j log|w| dt and ∫ P_j w/conj(w) dt, w = x - y, over elements F at one boundary
/// point x, j < p_F, in the order of `sources`.  The element that x ends is included:
/// both have limits there.
struct NodeMoments {
  Vector log;
  std::vector<Complex> phase;
};

/// Far elements by the far kernel, eight of `sources` at a time; near ones in closed
/// form. Errors are 1e-12 of an integral of size 1.
NodeMoments nodeMoments(const Mesh& mesh, const BoundaryPoint& x,
                        const std::vector<int>& sources);

}  // namespace epafi::bem
