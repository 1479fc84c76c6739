#include "bem/compressed/CompressedOperators.hpp"

#include "bem/algebra/SerialBlas.hpp"
#include "bem/compressed/CoupledEntries.hpp"
#include "bem/compressed/Interpolation.hpp"
#include "bem/compressed/NearBlocks.hpp"
#include "bem/compressed/Products.hpp"
#include "bem/compressed/ProxyRows.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

double length(Vec2 a) { return std::sqrt(dot(a, a)); }

std::vector<Unknown> allUnknowns(const Space& space, const LocalCoupling& local) {
  std::vector<Unknown> all = unknownsOf(space);
  for (const int element : local.elements)
    all.push_back({element, -1, true});
  return all;
}

// Both of a node, and across the line to the node that is farthest from it.
std::vector<Index> restingDisplacements(const Space& space) {
  const Mesh& mesh = space.mesh();
  if (mesh.outline().loops() == 1)
    return {};
  int farthest = 0;
  Vec2 offset{};
  for (int e = 0; mesh.outline().edge(mesh[e].piece.edge).loop == 0; ++e) {
    const Vec2 d = mesh.difference(mesh.at(e, -1), mesh.at(0, -1));
    if (length(d) > length(offset)) {
      farthest = e;
      offset = d;
    }
  }
  const int across = std::abs(offset.x) > std::abs(offset.y) ? 1 : 0;
  return {space.displacement(0, 0, 0), space.displacement(0, 0, 1),
          space.displacement(farthest, 0, across)};
}

}  // namespace

class CompressedOperators::Builder {
 public:
  Builder(CompressedOperators& out, const Space& space, const Lame& lame,
          const Compression& options, const LocalCoupling& local)
      : out_(out),
        space_(space),
        lame_(lame),
        options_(options),
        near_(space, lame, out.tree_),
        added_(out.unknowns_.size()),
        largestAdded_(out.unknowns_.size()) {
    for (const LocalCoupling::Entry& entry : local.entries) {
      added_[at(entry.row)].push_back({entry.column, entry.value});
      if (entry.row != entry.column)
        added_[at(entry.column)].push_back({entry.row, entry.value});
      for (const Index i : {entry.row, entry.column})
        largestAdded_[at(i)] = std::max(largestAdded_[at(i)], std::abs(entry.value));
    }
  }

  void build() {
    const ClusterTree& tree = out_.tree_;
    out_.parts_.resize(static_cast<std::size_t>(tree.size()));
    fillLeaves();
    for (int l = tree.levels() - 1; l >= 0; --l) {
      const std::vector<int>& level = tree.level(l);
      for (const int c : level)
        if (!tree[c].isLeaf())
          gather(c);
#pragma omp parallel
      {
        Worker worker(*this);
#pragma omp for schedule(dynamic, 1)
        for (std::size_t k = 0; k < level.size(); ++k) {
          worker.fillBlock(level[k]);
          if (l > 0)
            worker.compress(level[k]);
        }
      }
    }
  }

 private:
  struct Added {
    Index other;
    double value;
  };

  /// One for each thread.
  class Worker {
   public:
    explicit Worker(const Builder& builder)
        : builder_(builder),
          entries_(builder.space_, builder.lame_, builder.near_, builder.out_.unknowns_),
          proxies_(builder.space_, builder.lame_, builder.out_.unknowns_,
                   builder.options_.ratio, builder.options_.tolerance),
          places_(builder.out_.unknowns_.size(), -1) {}

    void fillBlock(int c) {
      const Cluster& cluster = builder_.out_.tree_[c];
      Part& part = builder_.part(c);
      if (cluster.isLeaf()) {
        part.block = entries_.symmetric(part.active);
        addLocal(part.active, part.active, part.block);
      } else {
        part.block = entriesOf(builder_.part(cluster.children[0]).skeleton,
                               builder_.part(cluster.children[1]).skeleton);
      }
    }

    void compress(int c) {
      Part& part = builder_.part(c);
      const std::vector<Index> near = builder_.nearUnknowns(c);
      const double radius = builder_.out_.tree_[c].radius;
      const auto n = static_cast<Index>(part.active.size());
      const Matrix entries = entriesOf(near, part.active);
      const Matrix fields = proxies_(builder_.out_.tree_, c, part.active);
      const Weighting weight(builder_, part.active.size(), radius);
      // a point's share of the circle
      const double share = std::sqrt(2 * 3.14159265358979323846 * options().ratio *
                                     radius / proxies_.points());
      constexpr Index forces = 2;
      const Index first = fields.rows() + forces;
      Matrix a(first + entries.rows(), n);
      Vector weights;
      double largest = 0;
      for (const Index row : near)
        weights.push_back(weight(row));
      for (Index j = 0; j < n; ++j) {
        const Index unknown = part.active[at(j)];
        const double own = weight(unknown);
        double square = 0;
        for (Index i = 0; i < fields.rows(); ++i) {
          a(i, j) = own * share * fields(i, j);
          square += a(i, j) * a(i, j);
        }
        largest = std::max(largest, square);
        const auto [component, force] = builder_.netForce(unknown);
        a(fields.rows() + component, j) = own * std::sqrt(radius) * force;
        for (Index i = 0; i < entries.rows(); ++i)
          a(first + i, j) = own * weights[at(i)] * entries(i, j);
      }
      Interpolation kept =
          interpolateColumns(std::move(a), options().tolerance * std::sqrt(largest));
      for (const Index k : kept.skeleton)
        part.skeleton.push_back(part.active[at(k)]);
      for (Index j = 0; j < n; ++j) {
        const double own = weight(part.active[at(j)]);
        for (Index i = 0; i < kept.weights.rows(); ++i)
          kept.weights(i, j) *= weight(part.skeleton[at(i)]) / own;
      }
      part.weights = std::move(kept.weights);
    }

   private:
    const Compression& options() const { return builder_.options_; }

    Matrix entriesOf(const std::vector<Index>& rows, const std::vector<Index>& columns) {
      Matrix result = entries_(rows, columns);
      addLocal(rows, columns, result);
      return result;
    }

    void addLocal(const std::vector<Index>& rows, const std::vector<Index>& columns,
                  Matrix& result) {
      const auto& added = builder_.added_;
      for (std::size_t i = 0; i < rows.size(); ++i)
        places_[at(rows[i])] = static_cast<Index>(i);
      for (std::size_t j = 0; j < columns.size(); ++j)
        for (const Added& entry : added[at(columns[j])])
          if (places_[at(entry.other)] >= 0)
            result(places_[at(entry.other)], static_cast<Index>(j)) += entry.value;
      for (const Index row : rows)
        places_[at(row)] = -1;
    }

    const Builder& builder_;
    CoupledEntries entries_;
    ProxyRows proxies_;
    std::vector<Index> places_;
  };

  /// What makes unknowns of a cluster comparable: functions of size one in L², densities in
  /// stresses, displacements over the cluster's radius.  Elements much shorter than the
  /// cluster's unknowns are apart count as longer; with their own sizes graded meshes would
  /// have larger ranks.
  class Weighting {
   public:
    Weighting(const Builder& builder, std::size_t count, double radius)
        : builder_(builder),
          radius_(radius),
          shortest_(4 * radius / static_cast<double>(count)) {}

    double operator()(Index unknown) const {
      const Mesh& mesh = builder_.space_.mesh();
      const Unknown& u = builder_.out_.unknowns_[at(unknown)];
      const Element& element = mesh[u.element];
      const double own = 2 * element.half;
      if (u.local < 0)
        return std::sqrt(std::max(own, shortest_)) / builder_.largestAdded_[at(unknown)];
      const LocalFunctions local(element);
      if (u.local >= local.displacements) {
        const int i = (u.local - local.displacements) / 2;
        return std::sqrt(std::max(own, shortest_) * (2 * i + 1)) / own;
      }
      const double size = u.isNode ? element.half + mesh[element.previous].half : own;
      // ∫ φ_k² dt on [-1, 1] over that of a hat
      const int k = u.local / 2;
      const double square = k < 2 ? 1 : 3.0 / ((2 * k + 1) * (2 * k - 3));
      return radius_ / std::sqrt(std::max(size, shortest_) * square);
    }

   private:
    const Builder& builder_;
    double radius_;
    double shortest_;
  };

  Part& part(int c) const { return out_.parts_[static_cast<std::size_t>(c)]; }

  void fillLeaves() {
    for (Index i = 0; i < out_.size(); ++i)
      part(out_.leafOf(i)).active.push_back(i);
  }

  void gather(int c) {
    for (const int child : out_.tree_[c].children)
      part(c).active.insert(part(c).active.end(), part(child).skeleton.begin(),
                            part(child).skeleton.end());
  }

  /// The force that a unit of an unknown puts on the body, and its component.
  std::pair<Index, double> netForce(Index unknown) const {
    const Unknown& u = out_.unknowns_[at(unknown)];
    const Element& element = space_.mesh()[u.element];
    const int i = u.local - LocalFunctions(element).displacements;
    return {i == 1 ? 1 : 0, i == 0 || i == 1 ? 2 * element.half : 0};
  }

  /// Does an unknown's function reach into the circle of radius r around a cluster?
  bool reaches(Index unknown, int c, double r) const {
    const Mesh& mesh = space_.mesh();
    const Unknown& u = out_.unknowns_[at(unknown)];
    const auto touches = [&](int e) {
      return length(out_.tree_.fromCentre(c, mesh.at(e, 0))) - mesh[e].half < r;
    };
    return touches(u.element) || (u.isNode && touches(mesh[u.element].previous));
  }

  /// Those of other clusters of the level that proxies do not stand for.
  std::vector<Index> nearUnknowns(int c) const {
    const ClusterTree& tree = out_.tree_;
    const double r = options_.ratio * tree[c].radius;
    std::vector<Index> near;
    std::vector<int> waiting = {0};
    constexpr double slack = 2;  // circles of children may stick out of their parents'
    while (!waiting.empty()) {
      const int other = waiting.back();
      waiting.pop_back();
      if (other == c || length(tree.between(c, other)) > r + slack * tree[other].radius)
        continue;
      if (!tree[other].isLeaf() && tree[other].level < tree[c].level) {
        waiting.insert(waiting.end(), {tree[other].children[1], tree[other].children[0]});
        continue;
      }
      for (const Index unknown : part(other).active)
        if (reaches(unknown, c, r))
          near.push_back(unknown);
    }
    return near;
  }

  CompressedOperators& out_;
  const Space& space_;
  Lame lame_;
  const Compression& options_;
  NearBlocks near_;
  std::vector<std::vector<Added>> added_;
  Vector largestAdded_;
};

CompressedOperators::CompressedOperators(const Space& space, const Lame& lame,
                                         const Compression& options,
                                         const LocalCoupling& local)
    : displacements_(space.displacements()),
      densities_(space.densities()),
      unknowns_(allUnknowns(space, local)),
      tree_(space, options.leafUnknowns),
      floating_(restingDisplacements(space)) {
  const SerialBlas serial;
  Builder(*this, space, lame, options, local).build();
}

// Upwards what leaves each cluster, downwards what comes to it from outside.
Matrix CompressedOperators::times(const Matrix& x) const {
  const SerialBlas serial;
  const Index columns = x.columns();
  Matrix result(x.rows(), columns);
  std::vector<Matrix> out(parts_.size());
  std::vector<Matrix> in(parts_.size());
  const auto active = [&](int c) {
    const Cluster& cluster = tree_[c];
    return cluster.isLeaf() ? rowsOf(x, part(c).active)
                            : stacked(out[static_cast<std::size_t>(cluster.children[0])],
                                      out[static_cast<std::size_t>(cluster.children[1])]);
  };
  for (int l = tree_.levels() - 1; l > 0; --l) {
    const std::vector<int>& level = tree_.level(l);
#pragma omp parallel for schedule(dynamic, 1)
    for (std::size_t k = 0; k < level.size(); ++k)
      out[static_cast<std::size_t>(level[k])] =
          product(part(level[k]).weights, active(level[k]));
  }
  for (int l = 0; l < tree_.levels(); ++l) {
    const std::vector<int>& level = tree_.level(l);
#pragma omp parallel for schedule(dynamic, 1)
    for (std::size_t k = 0; k < level.size(); ++k) {
      const int c = level[k];
      const Part& own = part(c);
      Matrix all(static_cast<Index>(own.active.size()), columns);
      if (l > 0)
        addTransposedProduct(1, own.weights, in[static_cast<std::size_t>(c)], all);
      if (tree_[c].isLeaf()) {
        addProduct(1, own.block, rowsOf(x, own.active), all);
        putRows(all, own.active, result);
        continue;
      }
      const auto first = static_cast<std::size_t>(tree_[c].children[0]);
      const auto second = static_cast<std::size_t>(tree_[c].children[1]);
      in[first] = rowsBetween(all, 0, out[first].rows());
      in[second] = rowsBetween(all, out[first].rows(), all.rows());
      addProduct(1, own.block, out[second], in[first]);
      addTransposedProduct(1, own.block, out[first], in[second]);
    }
  }
  return result;
}

CompressedOperators::Ranks CompressedOperators::ranks(int level) const {
  Ranks ranks;
  for (const int c : tree_.level(level)) {
    const auto k = static_cast<Index>(part(c).skeleton.size());
    ranks.largest = std::max(ranks.largest, k);
    ranks.mean += static_cast<double>(k) / static_cast<double>(tree_.level(level).size());
  }
  return ranks;
}

std::size_t CompressedOperators::bytes() const {
  std::size_t entries = 0;
  for (const Part& part : parts_)
    entries += static_cast<std::size_t>(part.weights.rows() * part.weights.columns() +
                                        part.block.rows() * part.block.columns());
  return entries * sizeof(double);
}

}  // namespace epafi::bem
