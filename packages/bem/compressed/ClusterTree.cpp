#include "bem/compressed/ClusterTree.hpp"

#include "bem/base/Box.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace epafi::bem {

namespace {

std::vector<ClusterPlace> inOrder(const Mesh& mesh) {
  std::vector<ClusterPlace> order;
  order.reserve(mesh.size());
  for (int e = 0; e < mesh.size(); ++e)
    order.push_back({0, e, mesh.outline().edge(mesh[e].piece.edge).loop});
  return order;
}

/// Clusters by places in an order alone.
class Division {
 public:
  Division(const std::vector<const Space*>& spaces,
           const std::vector<ClusterPlace>& order, Index leafUnknowns)
      : order_(order), leafUnknowns_(leafUnknowns), before_(1, 0) {
    for (const ClusterPlace& place : order) {
      const Element& element = spaces[place.body]->mesh()[place.element];
      before_.push_back(before_.back() + 2 * (element.degree + element.densities));
    }
    divide(0, static_cast<int>(order.size()), 0, -1);
  }

  std::vector<Cluster> take() { return std::move(clusters_); }

 private:
  int divide(int first, int last, int level, int parent) {
    const int number = static_cast<int>(clusters_.size());
    Cluster cluster;
    cluster.first = first;
    cluster.last = last;
    cluster.level = level;
    cluster.parent = parent;
    clusters_.push_back(cluster);
    if (before_[last] - before_[first] <= leafUnknowns_ || last - first == 1)
      return number;
    const int cut = middle(first, last);
    const int left = divide(first, cut, level + 1, number);
    const int right = divide(cut, last, level + 1, number);
    clusters_[number].children[0] = left;
    clusters_[number].children[1] = right;
    return number;
  }

  // Half the unknowns, or the end of a stretch that comes nearest to it.
  int middle(int first, int last) const {
    const double half = 0.5 * static_cast<double>(before_[first] + before_[last]);
    const auto distance = [&](int k) {
      return std::abs(static_cast<double>(before_[k]) - half);
    };
    int best = first + 1;
    bool endsStretch = false;
    for (int k = first + 1; k < last; ++k) {
      const bool ends = order_[k].stretch != order_[k - 1].stretch;
      if (ends == endsStretch ? distance(k) < distance(best) : ends) {
        best = k;
        endsStretch = ends;
      }
    }
    return best;
  }

  const std::vector<ClusterPlace>& order_;
  Index leafUnknowns_;
  std::vector<Index> before_;  ///< unknowns of the places before each
  std::vector<Cluster> clusters_;
};

}  // namespace

ClusterTree::ClusterTree(const Space& space, Index leafUnknowns)
    : ClusterTree({&space}, inOrder(space.mesh()), 0, leafUnknowns) {}

ClusterTree::ClusterTree(const std::vector<const Space*>& spaces,
                         const std::vector<ClusterPlace>& order, int body,
                         Index leafUnknowns)
    : mesh_(&spaces[body]->mesh()),
      clusters_(Division(spaces, order, leafUnknowns).take()) {
  std::vector<int> before(1, 0);  // own places
  for (const ClusterPlace& place : order) {
    if (place.body == body)
      elements_.push_back(place.element);
    before.push_back(static_cast<int>(elements_.size()));
  }
  leafOf_.resize(elements_.size());
  for (int c = 0; c < size(); ++c) {
    Cluster& cluster = clusters_[c];
    cluster.first = before[cluster.first];
    cluster.last = before[cluster.last];
    if (!cluster.isEmpty())
      encircle(cluster);
    levels_.resize(std::max(levels_.size(), static_cast<std::size_t>(cluster.level + 1)));
    levels_[cluster.level].push_back(c);
    for (int k = cluster.first; k < cluster.last && cluster.isLeaf(); ++k)
      leafOf_[element(k)] = c;
  }
}

void ClusterTree::encircle(Cluster& cluster) const {
  cluster.anchor = mesh_->at(element((cluster.first + cluster.last) / 2), -1);
  std::vector<Vec2> points;
  const auto addPoints = [&](int e) {
    if (mesh_->isAxis(e))
      return;
    for (const double t : {-1.0, 0.0, 1.0})
      points.push_back(mesh_->difference(mesh_->at(e, t), cluster.anchor));
  };
  for (int k = cluster.first; k < cluster.last; ++k) {
    const int e = element(k);
    addPoints(e);
    // the hat at the first node stands on the element before, too
    const int previous = (*mesh_)[e].previous;
    if (k == cluster.first || element(k - 1) != previous)
      addPoints(previous);
  }
  Box box;
  for (const Vec2 x : points)
    box.add(x);
  cluster.centre = box.middle();
  for (const Vec2 x : points)
    cluster.radius = std::max(cluster.radius, norm(x - cluster.centre));
}

std::vector<int> ClusterTree::cut(int l) const {
  std::vector<int> result;
  for (int c = 0; c < size(); ++c)
    if (clusters_[c].level == l || (clusters_[c].level < l && clusters_[c].isLeaf()))
      result.push_back(c);
  return result;
}

bool ClusterTree::contains(int whole, int part) const {
  while (part > whole)
    part = (*this)[part].parent;
  return part == whole;
}

std::vector<char> ClusterTree::paths(const std::vector<int>& leaves) const {
  std::vector<char> on(clusters_.size());
  for (const int leaf : leaves)
    for (int c = leaf; c >= 0 && on[c] == 0; c = (*this)[c].parent)
      on[c] = 1;
  return on;
}

Vec2 ClusterTree::fromCentre(int c, const BoundaryPoint& x) const {
  const Cluster& cluster = (*this)[c];
  assert(!cluster.isEmpty());
  return mesh_->difference(x, cluster.anchor) - cluster.centre;
}

Vec2 ClusterTree::between(int from, int to) const {
  return fromCentre(from, (*this)[to].anchor) + (*this)[to].centre;
}

}  // namespace epafi::bem
