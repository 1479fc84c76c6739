#pragma once

#include "bem/compressed/ClusterTree.hpp"
#include "bem/compressed/Interpolation.hpp"
#include "bem/compressed/Subtrees.hpp"
#include "bem/operators/LocalFunctions.hpp"

namespace epafi::bem {

/// The part of one body in a compressed system.  Its unknowns have local numbers: those of
/// its space, then the additional ones of LocalCoupling.
struct BodyShare {
  std::vector<Index> numbers;  ///< global numbers of its unknowns
  std::vector<Unknown> unknowns;
  std::vector<Entry> entries;  ///< added between its unknowns
  /// For each unknown the other leaves to whose unknowns an added entry couples it.
  std::vector<std::vector<int>> abroad;
  std::vector<ClusterPart> parts;  ///< by cluster
};

/// Joins the parts of all bodies, cluster by cluster, with global numbers and the entries
/// `between` bodies; skeletons are joined, too.  Clusters have the same numbers in all trees;
/// `tree` is one of them.  Clusters of other processes have lists of unknowns only.
std::vector<ClusterPart> joined(std::vector<BodyShare> shares,
                                const std::vector<Entry>& between,
                                const ClusterTree& tree, const Subtrees& subtrees,
                                Index unknowns);

}  // namespace epafi::bem
