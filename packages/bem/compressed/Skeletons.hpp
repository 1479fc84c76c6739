#pragma once

#include "bem/base/Material.hpp"
#include "bem/compressed/BodyShare.hpp"
#include "bem/compressed/Subtrees.hpp"

namespace epafi::bem {

struct Compression {
  /// Of what a cluster's functions do outside it, relative to the largest.
  double tolerance = 1e-12;
  Index leafUnknowns = 200;
  /// Of the radii of the circles that stand for what is far, and of the cluster's.
  double ratio = 1.8;
};

/// Young's modulus, in what a body's stresses are counted.
inline double youngOf(const Lame& lame) { return 2 * lame.mu * (1 + lame.nu); }

/// Fills a body's parts from the leaves up: each cluster's skeleton from what it does to
/// unknowns nearby and to points that stand for all others; of other processes' clusters the
/// lists of unknowns alone.  Collective.                     [doc/theory/compression.md]
void skeletonise(BodyShare& share, const Space& space, const Lame& lame,
                 const ClusterTree& tree, const Compression& options,
                 const Subtrees& subtrees);

}  // namespace epafi::bem
