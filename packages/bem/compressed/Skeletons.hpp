#pragma once

#include "bem/compressed/BodyShare.hpp"
#include "bem/compressed/Subtrees.hpp"
#include "bem/operators/Kernel.hpp"

namespace epafi::bem {

struct Compression {
  /// Error of the far field of a function, relative to the largest in its cluster; of systems with more
  /// than 65536 unknowns smaller in proportion.
  double tolerance = 1e-12;
  Index leafUnknowns = 200;
  /// Radius of the proxy circle over the radius of the cluster.
  double ratio = 1.8;
};

/// Computes the parts of a body from the leaves to the root.  The skeleton of a cluster
/// interpolates its entries with unknowns nearby and its ProxyRows.  Clusters of other
/// processes get lists of unknowns only.  Collective.        [doc/theory/compression.md]
void skeletonise(BodyShare& share, const Space& space, const Kernel& kernel,
                 const ClusterTree& tree, const Compression& options,
                 const Subtrees& subtrees);

}  // namespace epafi::bem
