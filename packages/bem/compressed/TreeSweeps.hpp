#pragma once

#include "bem/base/Parallel.hpp"
#include "bem/compressed/Subtrees.hpp"

namespace epafi::bem {

/// visit(c) for the clusters of a level that are asked for, in parallel, each of which takes
/// work(c) [ns], see Parallel.hpp; a single one has all threads for itself, see byColumns.
template <class Asked, class Work, class Visit>
void visitLevel(const ClusterTree& tree, int level, const Asked& asked, const Work& work,
                const Visit& visit) {
  std::vector<int> clusters;
  double all = 0;
  for (const int c : tree.level(level))
    if (asked(c)) {
      clusters.push_back(c);
      all += work(c);
    }
  parallelFor({static_cast<Index>(clusters.size()), all},
              [&](Index k) { visit(clusters[at(k)]); });
}

/// visit(c) for all clusters of `on` that are mine, children first: this process's subtrees,
/// then meet(), where processes tell each other what they have of the roots, then what is
/// everybody's.
template <class Work, class Visit, class Meet>
void upwards(const ClusterTree& tree, const Subtrees& subtrees,
             const std::vector<char>& on, const Work& work, const Visit& visit,
             const Meet& meet) {
  for (const bool everybodys : {false, true}) {
    for (int l = tree.levels() - 1; l >= 0; --l)
      visitLevel(
          tree, l,
          [&](int c) {
            return on[c] != 0 && subtrees.isMine(c) &&
                   subtrees.isEverybodys(c) == everybodys;
          },
          work, visit);
    if (!everybodys && !subtrees.isAlone())
      meet();
  }
}

/// The same, parents first; nothing is to be told.
template <class Work, class Visit>
void downwards(const ClusterTree& tree, const Subtrees& subtrees,
               const std::vector<char>& on, const Work& work, const Visit& visit) {
  for (int l = 0; l < tree.levels(); ++l)
    visitLevel(
        tree, l, [&](int c) { return on[c] != 0 && subtrees.isMine(c); }, work, visit);
}

}  // namespace epafi::bem
