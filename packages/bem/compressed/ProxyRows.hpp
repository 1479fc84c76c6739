#pragma once

#include "bem/compressed/ClusterTree.hpp"
#include "bem/operators/FarBlocks.hpp"
#include "bem/operators/Kernel.hpp"
#include "bem/operators/LocalFunctions.hpp"

#include <vector>

namespace epafi::bem {

/// Far field of the functions of a cluster, sampled at points of a circle around it (proxy
/// points): the displacements
///
///   K u - V ψ,
///
/// which determine the field outside the circle.  The signs are those of the rows of
/// the coupled system; with K u + V ψ the skeleton would be inaccurate in these rows on rough
/// boundaries, where displacements and densities both contribute.
class ProxyRows {
 public:
  /// `ratio`: radius of the circle over that of the cluster.  `tolerance`: relative error.
  ProxyRows(const Space& space, const Kernel& kernel,
            const std::vector<Unknown>& unknowns, double ratio, double tolerance);

  int points() const { return points_; }
  /// Rows: each component of all points; columns: the unknowns `columns`.
  Matrix operator()(const ClusterTree& tree, int cluster,
                    const std::vector<Index>& columns);

 private:
  const Space& space_;
  const std::vector<Unknown>& unknowns_;
  double ratio_;
  int points_;
  std::unique_ptr<FarBlocks> far_;
};

}  // namespace epafi::bem
