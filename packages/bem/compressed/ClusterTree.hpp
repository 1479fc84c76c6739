#pragma once

#include "bem/space/Space.hpp"

#include <vector>

namespace epafi::bem {

/// Elements first ... last - 1 of one or several loops, in a circle.
struct Cluster {
  int first = 0;
  int last = 0;
  int level = 0;
  int parent = -1;
  int children[2] = {-1, -1};
  BoundaryPoint anchor;  ///< one of its nodes: differences keep their digits
  Vec2 centre;           ///< of the circle around it, from the anchor
  double radius = 0;

  bool isLeaf() const { return children[0] < 0; }
};

/// The boundary cut in two again and again, where unknowns are halved or a loop ends.
class ClusterTree {
 public:
  /// Leaves have at most so many unknowns, or one element.
  ClusterTree(const Space& space, Index leafUnknowns);

  int size() const { return static_cast<int>(clusters_.size()); }
  const Cluster& operator[](int c) const {
    return clusters_[static_cast<std::size_t>(c)];
  }
  /// The root is 0, and children come behind their parents.
  int levels() const { return static_cast<int>(levels_.size()); }
  /// Clusters of a level.
  const std::vector<int>& level(int l) const {
    return levels_[static_cast<std::size_t>(l)];
  }
  /// The boundary cut into clusters of a level and leaves above it.
  std::vector<int> cut(int l) const;

  /// By cluster: is it one of these leaves, or above one?
  std::vector<char> paths(const std::vector<int>& leaves) const;

  int leafOf(int element) const { return leafOf_[static_cast<std::size_t>(element)]; }

  /// From the centre of one cluster to a point, and to the centre of another.
  Vec2 fromCentre(int c, const BoundaryPoint& x) const;
  Vec2 between(int from, int to) const;

  const Mesh& mesh() const { return *mesh_; }

 private:
  int divide(int first, int last, int level, int parent);
  int middle(int first, int last) const;
  void encircle(Cluster& cluster) const;

  const Mesh* mesh_;
  Index leafUnknowns_;
  std::vector<Index> before_;  ///< unknowns of the elements before each
  std::vector<Cluster> clusters_;
  std::vector<std::vector<int>> levels_;
  std::vector<int> leafOf_;
};

}  // namespace epafi::bem
