#pragma once

#include "bem/mesh/Mesh.hpp"
#include "bem/moments/LegendreMoments.hpp"

namespace epafi::bem {

/// ∫ P_j log|w| dt and ∫ P_j w/conj(w) dt, w = x - y, over an element at one boundary
/// point x, j below its degree.  x may be one of its ends: both have limits there.
struct EndMoments {
  std::array<double, largestDegree> log{};
  std::array<Complex, largestDegree> phase{};
};

/// In closed form, to 1e-14 of an integral of size 1.
EndMoments endMoments(const Mesh& mesh, int source, const BoundaryPoint& x);

}  // namespace epafi::bem
