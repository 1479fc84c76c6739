#include "bem/compressed/ClusterTree.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

ClusterTree::ClusterTree(const Space& space, Index leafUnknowns)
    : mesh_(&space.mesh()), leafUnknowns_(leafUnknowns), before_(1, 0) {
  for (const Element& element : mesh_->elements())
    before_.push_back(before_.back() + 2 * (element.degree + element.densities));
  leafOf_.resize(static_cast<std::size_t>(mesh_->size()));
  divide(0, mesh_->size(), 0, -1);
  for (int c = 0; c < size(); ++c) {
    const Cluster& cluster = clusters_[static_cast<std::size_t>(c)];
    levels_.resize(std::max(levels_.size(), static_cast<std::size_t>(cluster.level + 1)));
    levels_[static_cast<std::size_t>(cluster.level)].push_back(c);
    if (cluster.isLeaf())
      std::fill(leafOf_.begin() + cluster.first, leafOf_.begin() + cluster.last, c);
  }
}

namespace {

double length(Vec2 a) { return std::hypot(a.x, a.y); }

}  // namespace

int ClusterTree::divide(int first, int last, int level, int parent) {
  const int number = size();
  Cluster cluster;
  cluster.first = first;
  cluster.last = last;
  cluster.level = level;
  cluster.parent = parent;
  encircle(cluster);
  clusters_.push_back(cluster);
  if (before_[at(last)] - before_[at(first)] <= leafUnknowns_ || last - first == 1)
    return number;
  const int cut = middle(first, last);
  const int left = divide(first, cut, level + 1, number);
  const int right = divide(cut, last, level + 1, number);
  clusters_[static_cast<std::size_t>(number)].children[0] = left;
  clusters_[static_cast<std::size_t>(number)].children[1] = right;
  return number;
}

// Half the unknowns, or the end of a loop that comes nearest to it.
int ClusterTree::middle(int first, int last) const {
  const double half = 0.5 * static_cast<double>(before_[at(first)] + before_[at(last)]);
  const auto distance = [&](int e) {
    return std::abs(static_cast<double>(before_[at(e)]) - half);
  };
  const auto loopOf = [&](int e) {
    return mesh_->outline().edge((*mesh_)[e].piece.edge).loop;
  };
  int best = first + 1;
  bool endsLoop = false;
  for (int e = first + 1; e < last; ++e) {
    const bool ends = loopOf(e) != loopOf(e - 1);
    if (ends == endsLoop ? distance(e) < distance(best) : ends) {
      best = e;
      endsLoop = ends;
    }
  }
  return best;
}

void ClusterTree::encircle(Cluster& cluster) const {
  cluster.anchor = mesh_->at((cluster.first + cluster.last) / 2, -1);
  std::vector<Vec2> points;
  const auto addPoints = [&](int e) {
    for (const double t : {-1.0, 0.0, 1.0})
      points.push_back(mesh_->difference(mesh_->at(e, t), cluster.anchor));
  };
  for (int e = cluster.first; e < cluster.last; ++e)
    addPoints(e);
  // the hat at the first node stands on the element before, too
  addPoints((*mesh_)[cluster.first].previous);
  Vec2 low = points.front();
  Vec2 high = low;
  for (const Vec2 x : points) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y)};
  }
  cluster.centre = 0.5 * (low + high);
  for (const Vec2 x : points)
    cluster.radius = std::max(cluster.radius, length(x - cluster.centre));
}

std::vector<int> ClusterTree::cut(int l) const {
  std::vector<int> result;
  for (int c = 0; c < size(); ++c)
    if (clusters_[static_cast<std::size_t>(c)].level == l ||
        (clusters_[static_cast<std::size_t>(c)].level < l &&
         clusters_[static_cast<std::size_t>(c)].isLeaf()))
      result.push_back(c);
  return result;
}

std::vector<char> ClusterTree::paths(const std::vector<int>& leaves) const {
  std::vector<char> on(clusters_.size());
  for (const int leaf : leaves)
    for (int c = leaf; c >= 0 && on[static_cast<std::size_t>(c)] == 0;
         c = (*this)[c].parent)
      on[static_cast<std::size_t>(c)] = 1;
  return on;
}

Vec2 ClusterTree::fromCentre(int c, const BoundaryPoint& x) const {
  const Cluster& cluster = (*this)[c];
  return mesh_->difference(x, cluster.anchor) - cluster.centre;
}

Vec2 ClusterTree::between(int from, int to) const {
  return fromCentre(from, (*this)[to].anchor) + (*this)[to].centre;
}

}  // namespace epafi::bem
