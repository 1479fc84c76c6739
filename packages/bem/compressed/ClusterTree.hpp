#pragma once

#include "bem/space/Space.hpp"

#include <vector>

namespace epafi::bem {

/// Elements of one or several loops at the positions first ... last - 1 in the order of the
/// tree, and a circle around them.
struct Cluster {
  int first = 0;
  int last = 0;
  int level = 0;
  int parent = -1;
  int children[2] = {-1, -1};
  BoundaryPoint anchor;  ///< a node; differences from it avoid cancellation
  Vec2 centre;           ///< of the circle, relative to the anchor
  double radius = 0;

  bool isLeaf() const { return children[0] < 0; }
  bool isEmpty() const { return first == last; }
};

/// An element of one of several bodies, and the stretch to which it belongs: a loop or a part of
/// one, where a tree prefers to cut between stretches.
struct ClusterPlace {
  int body;
  int element;
  int stretch;
};

/// Binary cluster tree of the boundary.  A cluster is divided at the end of a stretch or where
/// its unknowns are halved.
///
/// Several bodies are divided together.  Each has a tree of its own with the same numbers,
/// children and parents of clusters; clusters may be empty.
class ClusterTree {
 public:
  /// Tree of one body in the order of its elements.  \param leafUnknowns maximum in a leaf
  ClusterTree(const Space& space, Index leafUnknowns);
  /// Tree of `body` in the common order of the elements of all bodies.
  ClusterTree(const std::vector<const Space*>& spaces,
              const std::vector<ClusterPlace>& order, int body, Index leafUnknowns);

  int size() const { return static_cast<int>(clusters_.size()); }
  const Cluster& operator[](int c) const { return clusters_[c]; }
  /// Cluster 0 is the root; children have larger numbers than their parents.
  int levels() const { return static_cast<int>(levels_.size()); }
  /// Clusters of a level.
  const std::vector<int>& level(int l) const { return levels_[l]; }
  /// Partition of the boundary: the clusters of level l and the leaves of lower levels.
  std::vector<int> cut(int l) const;

  /// By cluster: is it one of these leaves or an ancestor of one?
  std::vector<char> paths(const std::vector<int>& leaves) const;

  /// The element at a position in the order of the tree.
  int element(int place) const { return elements_[place]; }
  int leafOf(int element) const { return leafOf_[element]; }
  /// Is `part` a descendant of `whole`, or the same cluster?
  bool contains(int whole, int part) const;

  /// Vector from the centre of a cluster to a point, or to the centre of another cluster.
  /// \pre the clusters are not empty
  Vec2 fromCentre(int c, const BoundaryPoint& x) const;
  Vec2 between(int from, int to) const;

  const Mesh& mesh() const { return *mesh_; }

 private:
  void encircle(Cluster& cluster) const;

  const Mesh* mesh_;
  std::vector<int> elements_;  ///< in the tree's order
  std::vector<Cluster> clusters_;
  std::vector<std::vector<int>> levels_;
  std::vector<int> leafOf_;
};

}  // namespace epafi::bem
