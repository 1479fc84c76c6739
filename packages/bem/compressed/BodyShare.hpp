#pragma once

#include "bem/compressed/ClusterTree.hpp"
#include "bem/compressed/Interpolation.hpp"
#include "bem/compressed/Subtrees.hpp"
#include "bem/operators/LocalFunctions.hpp"

namespace epafi::bem {

/// What one body has in a compressed system, its unknowns in an order of their own: those of
/// its space and then further ones.
struct BodyShare {
  std::vector<Index> numbers;  ///< of its unknowns among all
  std::vector<Unknown> unknowns;
  std::vector<Entry> entries;  ///< between its own
  /// Of each unknown, the leaves of others on which it acts.
  std::vector<std::vector<int>> abroad;
  std::vector<ClusterPart> parts;  ///< by cluster
};

/// Bodies' shares side by side, their unknowns numbered among all: skeletons one behind the
/// other, and with the entries between bodies.  Clusters have the same numbers in all trees,
/// of which this is one.  Of other processes' clusters the lists of unknowns alone.
std::vector<ClusterPart> joined(std::vector<BodyShare> shares,
                                const std::vector<Entry>& between,
                                const ClusterTree& tree, const Subtrees& subtrees,
                                Index unknowns);

}  // namespace epafi::bem
