#pragma once

#include "bem/compressed/Subtrees.hpp"

namespace epafi::bem {

/// visit(c) for the clusters of a level that are asked for, by OpenMP's threads; a single
/// cluster has them for itself, see byColumns.
template <class Asked, class Visit>
void visitLevel(const ClusterTree& tree, int level, const Asked& asked,
                const Visit& visit) {
  std::vector<int> clusters;
  for (const int c : tree.level(level))
    if (asked(c))
      clusters.push_back(c);
#pragma omp parallel for schedule(dynamic, 1) if (clusters.size() > 1)
  // NOLINTNEXTLINE(modernize-loop-convert): OpenMP divides it
  for (std::size_t k = 0; k < clusters.size(); ++k)
    visit(clusters[k]);
}

/// visit(c) for all clusters of `on` that are mine, children first: this process's subtrees,
/// then meet(), where processes tell each other what they have of the roots, then what is
/// everybody's.
template <class Visit, class Meet>
void upwards(const ClusterTree& tree, const Subtrees& subtrees,
             const std::vector<char>& on, const Visit& visit, const Meet& meet) {
  for (const bool everybodys : {false, true}) {
    for (int l = tree.levels() - 1; l >= 0; --l)
      visitLevel(
          tree, l,
          [&](int c) {
            return on[c] != 0 && subtrees.isMine(c) &&
                   subtrees.isEverybodys(c) == everybodys;
          },
          visit);
    if (!everybodys && !subtrees.isAlone())
      meet();
  }
}

/// The same, parents first; nothing is to be told.
template <class Visit>
void downwards(const ClusterTree& tree, const Subtrees& subtrees,
               const std::vector<char>& on, const Visit& visit) {
  for (int l = 0; l < tree.levels(); ++l)
    visitLevel(
        tree, l, [&](int c) { return on[c] != 0 && subtrees.isMine(c); }, visit);
}

}  // namespace epafi::bem
