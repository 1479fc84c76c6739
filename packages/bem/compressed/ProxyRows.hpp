#pragma once

#include "bem/base/Material.hpp"
#include "bem/compressed/ClusterTree.hpp"
#include "bem/operators/FarBlocks.hpp"
#include "bem/operators/LocalFunctions.hpp"

#include <vector>

namespace epafi::bem {

/// What a cluster's functions do to everything outside a circle around it, seen by points
/// on that circle: the displacements
///
///   K u - V ψ,
///
/// of a field that satisfies the elastic equations outside; and its net force.  The signs
/// are those of the rows of the coupled system: with + V ψ rows of displacements and of
/// densities on rough boundaries, where both act, are not met.
class ProxyRows {
 public:
  /// `tolerance`: of the field outside, which falls off by powers of `ratio`.
  ProxyRows(const Space& space, const Lame& lame, const std::vector<Unknown>& unknowns,
            double ratio, double tolerance);

  int points() const { return points_; }
  /// Rows: x of all points, then y of them.
  Matrix operator()(const ClusterTree& tree, int cluster,
                    const std::vector<Index>& columns,
                    InstructionSet set = largestInstructionSet());

 private:
  const Space& space_;
  const std::vector<Unknown>& unknowns_;
  double ratio_;
  int points_;
  FarBlocks far_;
};

}  // namespace epafi::bem
