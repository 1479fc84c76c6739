#pragma once

#include "bem/compressed/Interpolation.hpp"

#include <vector>

namespace epafi::bem {

/// What a compressed system keeps of a cluster.
struct ClusterPart {
  std::vector<Index> active;  ///< a leaf's unknowns, or the skeletons of the children
  std::vector<Index> skeleton;
  Interpolation weights;  ///< T, of the active by the skeleton; of all but the root
  /// A leaf's entries, or those of one child's skeleton with the other's.
  Matrix block;
};

}  // namespace epafi::bem
