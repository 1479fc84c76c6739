#pragma once

#include "bem/space/Space.hpp"

#include <vector>

namespace epafi::bem {

/// Elements of one or several loops, at the places first ... last - 1 of the tree's order, in
/// a circle.
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
  bool isEmpty() const { return first == last; }
};

/// An element of one of several bodies, and the stretch that a tree does not mix with others
/// before it has to: a loop, or a part of it.
struct ClusterPlace {
  int body;
  int element;
  int stretch;
};

/// The boundary cut in two again and again, where unknowns are halved or a stretch ends.
///
/// Several bodies are cut as if they were one boundary, each with a tree of its own: their
/// clusters have the same numbers, children and parents, and may be empty.
class ClusterTree {
 public:
  /// Of one body in the order of its elements.  Leaves have at most so many unknowns, or one
  /// element.
  ClusterTree(const Space& space, Index leafUnknowns);
  /// What is one body's of elements of all, in an order.
  ClusterTree(const std::vector<const Space*>& spaces,
              const std::vector<ClusterPlace>& order, int body, Index leafUnknowns);

  int size() const { return static_cast<int>(clusters_.size()); }
  const Cluster& operator[](int c) const { return clusters_[c]; }
  /// The root is 0, and children come behind their parents.
  int levels() const { return static_cast<int>(levels_.size()); }
  /// Clusters of a level.
  const std::vector<int>& level(int l) const { return levels_[l]; }
  /// The boundary cut into clusters of a level and leaves above it.
  std::vector<int> cut(int l) const;

  /// By cluster: is it one of these leaves, or above one?
  std::vector<char> paths(const std::vector<int>& leaves) const;

  /// The element at a place of the order.
  int element(int place) const { return elements_[place]; }
  int leafOf(int element) const { return leafOf_[element]; }
  /// Is a cluster one of those that another is made of, or that one?
  bool contains(int whole, int part) const;

  /// From the centre of one cluster to a point, and to the centre of another, which are not
  /// empty.
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
