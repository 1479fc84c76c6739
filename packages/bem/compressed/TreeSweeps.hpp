#pragma once

#include "bem/base/Parallel.hpp"
#include "bem/compressed/Subtrees.hpp"

namespace epafi::bem {

/// Calls visit(c) in parallel for the clusters of a level with asked(c); work(c): estimated
/// work [ns], see Parallel.hpp.  A single cluster gets all threads, see byColumns.
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

/// Calls visit(c) for all clusters in `on` that this process computes, children before
/// parents: its subtrees first, then meet(), which exchanges data of the roots, then the
/// clusters above the roots.
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

/// Calls visit(c) for the same clusters, parents before children; without communication.
template <class Work, class Visit>
void downwards(const ClusterTree& tree, const Subtrees& subtrees,
               const std::vector<char>& on, const Work& work, const Visit& visit) {
  for (int l = 0; l < tree.levels(); ++l)
    visitLevel(
        tree, l, [&](int c) { return on[c] != 0 && subtrees.isMine(c); }, work, visit);
}

}  // namespace epafi::bem
