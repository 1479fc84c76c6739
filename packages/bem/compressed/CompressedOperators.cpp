#include "bem/compressed/CompressedOperators.hpp"

#include "bem/algebra/SerialBlas.hpp"
#include "bem/compressed/CoupledEntries.hpp"
#include "bem/compressed/FacingOrder.hpp"
#include "bem/compressed/Interpolation.hpp"
#include "bem/compressed/NearBlocks.hpp"
#include "bem/compressed/Products.hpp"
#include "bem/compressed/ProxyRows.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace epafi::bem {

namespace {

double length(Vec2 a) { return std::sqrt(dot(a, a)); }

double youngOf(const Lame& lame) { return 2 * lame.mu * (1 + lame.nu); }

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

/// What one body has in the system, its unknowns in an order of their own: those of its space
/// and then further ones.
struct CompressedOperators::Share {
  std::vector<Index> numbers;  ///< of its unknowns among all
  std::vector<Unknown> unknowns;
  std::vector<LocalCoupling::Entry> entries;  ///< between its own
  /// Of each unknown, the leaves of others on which it acts.
  std::vector<std::vector<int>> abroad;
  std::vector<Part> parts;
};

class CompressedOperators::Builder {
 public:
  Builder(Share& out, const Body& body, const ClusterTree& tree,
          const Compression& options)
      : out_(out),
        tree_(tree),
        space_(body.space),
        lame_(body.lame),
        young_(youngOf(lame_)),
        options_(options),
        near_(space_, lame_, tree),
        added_(out.unknowns.size()),
        largestAdded_(out.unknowns.size()) {
    for (const LocalCoupling::Entry& entry : out.entries) {
      added_[at(entry.row)].push_back({entry.column, entry.value});
      if (entry.row != entry.column)
        added_[at(entry.column)].push_back({entry.row, entry.value});
      for (const Index i : {entry.row, entry.column})
        largestAdded_[at(i)] = std::max(largestAdded_[at(i)], std::abs(entry.value));
    }
  }

  void build() {
    out_.parts.resize(static_cast<std::size_t>(tree_.size()));
    fillLeaves();
    for (int l = tree_.levels() - 1; l >= 0; --l) {
      const std::vector<int>& level = tree_.level(l);
      for (const int c : level)
        if (!tree_[c].isLeaf())
          gather(c);
#pragma omp parallel
      {
        Worker worker(*this);
#pragma omp for schedule(dynamic, 1)
        for (std::size_t k = 0; k < level.size(); ++k) {
          worker.fillBlock(level[k]);
          if (l > 0 && !tree_[level[k]].isEmpty())
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
          entries_(builder.space_, builder.lame_, builder.near_, builder.out_.unknowns),
          proxies_(builder.space_, builder.lame_, builder.out_.unknowns,
                   builder.options_.ratio, builder.options_.tolerance),
          places_(builder.out_.unknowns.size(), -1) {}

    void fillBlock(int c) {
      const Cluster& cluster = builder_.tree_[c];
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
      const double radius = builder_.tree_[c].radius;
      // what acts on another body outside the cluster stays as it is
      std::vector<Index> staying;
      std::vector<Index> places;
      std::vector<Index> active;
      for (std::size_t j = 0; j < part.active.size(); ++j)
        if (builder_.actsOutside(part.active[j], c)) {
          staying.push_back(static_cast<Index>(j));
        } else {
          places.push_back(static_cast<Index>(j));
          active.push_back(part.active[j]);
        }
      const auto n = static_cast<Index>(active.size());
      const Matrix entries = entriesOf(near, active);
      const Matrix fields = proxies_(builder_.tree_, c, active);
      const Weighting weight(builder_, part.active.size(), radius);
      const double stiffness = std::sqrt(builder_.young_);
      // a point's share of the circle
      const double share =
          stiffness * std::sqrt(2 * 3.14159265358979323846 * options().ratio * radius /
                                proxies_.points());
      constexpr Index forces = 2;
      const Index first = fields.rows() + forces;
      Matrix a(first + entries.rows(), n);
      Vector weights;
      double largest = 0;
      for (const Index row : near)
        weights.push_back(weight(row));
      for (Index j = 0; j < n; ++j) {
        const Index unknown = active[at(j)];
        const double own = weight(unknown);
        double square = 0;
        for (Index i = 0; i < fields.rows(); ++i) {
          a(i, j) = own * share * fields(i, j);
          square += a(i, j) * a(i, j);
        }
        largest = std::max(largest, square);
        const auto [component, force] = builder_.netForce(unknown);
        a(fields.rows() + component, j) = own / stiffness * std::sqrt(radius) * force;
        for (Index i = 0; i < entries.rows(); ++i)
          a(first + i, j) = own * weights[at(i)] * entries(i, j);
      }
      const Interpolation kept =
          n == 0 ? Interpolation()
                 : interpolateColumns(std::move(a),
                                      options().tolerance * std::sqrt(largest));
      const Index rank = kept.weights.rows();
      for (const Index k : kept.skeleton)
        part.skeleton.push_back(active[at(k)]);
      part.weights = Matrix(rank + static_cast<Index>(staying.size()),
                            static_cast<Index>(part.active.size()));
      for (Index j = 0; j < n; ++j) {
        const double own = weight(active[at(j)]);
        for (Index i = 0; i < rank; ++i)
          part.weights(i, places[at(j)]) =
              kept.weights(i, j) * weight(part.skeleton[at(i)]) / own;
      }
      for (std::size_t k = 0; k < staying.size(); ++k) {
        part.skeleton.push_back(part.active[at(staying[k])]);
        part.weights(rank + static_cast<Index>(k), staying[k]) = 1;
      }
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
  /// stresses of Young's modulus, displacements over the cluster's radius.  Elements much shorter than the
  /// cluster's unknowns are apart count as longer; with their own sizes graded meshes would
  /// have larger ranks.
  class Weighting {
   public:
    Weighting(const Builder& builder, std::size_t count, double radius)
        : builder_(builder),
          radius_(radius),
          stiffness_(std::sqrt(builder.young_)),
          shortest_(4 * radius / static_cast<double>(count)) {}

    double operator()(Index unknown) const {
      const Mesh& mesh = builder_.space_.mesh();
      const Unknown& u = builder_.out_.unknowns[at(unknown)];
      const Element& element = mesh[u.element];
      const double own = 2 * element.half;
      if (u.local < 0)
        return stiffness_ * std::sqrt(std::max(own, shortest_)) /
               builder_.largestAdded_[at(unknown)];
      const LocalFunctions local(element);
      if (u.local >= local.displacements) {
        const int i = (u.local - local.displacements) / 2;
        return stiffness_ * std::sqrt(std::max(own, shortest_) * (2 * i + 1)) / own;
      }
      const double size = u.isNode ? element.half + mesh[element.previous].half : own;
      // ∫ φ_k² dt on [-1, 1] over that of a hat
      const int k = u.local / 2;
      const double square = k < 2 ? 1 : 3.0 / ((2 * k + 1) * (2 * k - 3));
      return radius_ / stiffness_ / std::sqrt(std::max(size, shortest_) * square);
    }

   private:
    const Builder& builder_;
    double radius_;
    double stiffness_;
    double shortest_;
  };

  Part& part(int c) const { return out_.parts[static_cast<std::size_t>(c)]; }

  void fillLeaves() {
    for (std::size_t i = 0; i < out_.unknowns.size(); ++i)
      part(tree_.leafOf(out_.unknowns[i].element))
          .active.push_back(static_cast<Index>(i));
  }

  bool actsOutside(Index unknown, int c) const {
    const std::vector<int>& leaves = out_.abroad[at(unknown)];
    return std::any_of(leaves.begin(), leaves.end(),
                       [&](int leaf) { return !tree_.contains(c, leaf); });
  }

  void gather(int c) {
    for (const int child : tree_[c].children)
      part(c).active.insert(part(c).active.end(), part(child).skeleton.begin(),
                            part(child).skeleton.end());
  }

  /// The force that a unit of an unknown puts on the body, and its component.
  std::pair<Index, double> netForce(Index unknown) const {
    const Unknown& u = out_.unknowns[at(unknown)];
    const Element& element = space_.mesh()[u.element];
    const int i = u.local - LocalFunctions(element).displacements;
    return {i == 1 ? 1 : 0, i == 0 || i == 1 ? 2 * element.half : 0};
  }

  /// Does an unknown's function reach into the circle of radius r around a cluster?
  bool reaches(Index unknown, int c, double r) const {
    const Mesh& mesh = space_.mesh();
    const Unknown& u = out_.unknowns[at(unknown)];
    const auto touches = [&](int e) {
      return length(tree_.fromCentre(c, mesh.at(e, 0))) - mesh[e].half < r;
    };
    return touches(u.element) || (u.isNode && touches(mesh[u.element].previous));
  }

  /// Those of other clusters of the level that proxies do not stand for.
  std::vector<Index> nearUnknowns(int c) const {
    const ClusterTree& tree = tree_;
    const double r = options_.ratio * tree[c].radius;
    std::vector<Index> near;
    std::vector<int> waiting = {0};
    constexpr double slack = 2;  // circles of children may stick out of their parents'
    while (!waiting.empty()) {
      const int other = waiting.back();
      waiting.pop_back();
      if (other == c || tree[other].isEmpty() ||
          length(tree.between(c, other)) > r + slack * tree[other].radius)
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

  Share& out_;
  const ClusterTree& tree_;
  const Space& space_;
  Lame lame_;
  double young_;
  const Compression& options_;
  NearBlocks near_;
  std::vector<std::vector<Added>> added_;
  Vector largestAdded_;
};

CompressedOperators::CompressedOperators(const std::vector<Body>& bodies,
                                         const Compression& options,
                                         const LocalCoupling& local) {
  const SerialBlas serial;
  std::vector<const Space*> spaces;
  std::vector<Share> shares(bodies.size());
  /// Of all unknowns: whose, and which of its own.
  std::vector<std::pair<std::size_t, Index>> owners;
  const auto add = [&](std::size_t b, const Unknown& unknown) {
    owners.emplace_back(b, static_cast<Index>(shares[b].unknowns.size()));
    shares[b].numbers.push_back(static_cast<Index>(owners.size()) - 1);
    shares[b].unknowns.push_back(unknown);
  };
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Space& space = bodies[b].space;
    const auto first = static_cast<Index>(owners.size());
    ranges_.push_back({first, first + space.displacements(),
                       first + space.displacements() + space.densities(),
                       youngOf(bodies[b].lame)});
    spaces.push_back(&space);
    for (const Index i : restingDisplacements(space))
      floating_.push_back(first + i);
    for (const Unknown& unknown : unknownsOf(space))
      add(b, unknown);
  }
  for (std::size_t k = 0; k < local.elements.size(); ++k)
    add(local.bodies.empty() ? 0 : static_cast<std::size_t>(local.bodies[k]),
        {local.elements[k], -1, true});

  const auto elementOf = [&](Index unknown) {
    const auto [b, own] = owners[at(unknown)];
    return BodyElement{static_cast<int>(b), shares[b].unknowns[at(own)].element};
  };
  std::vector<Link> links;
  LocalCoupling between;
  for (const LocalCoupling::Entry& entry : local.entries) {
    const auto [b, row] = owners[at(entry.row)];
    const auto [d, column] = owners[at(entry.column)];
    if (b == d) {
      shares[b].entries.push_back({row, column, entry.value});
      continue;
    }
    between.entries.push_back(entry);
    links.push_back({elementOf(std::max(entry.row, entry.column)),
                     elementOf(std::min(entry.row, entry.column)),
                     std::abs(entry.value)});
  }
  const std::vector<ClusterPlace> order = facingOrder(spaces, links);
  for (std::size_t b = 0; b < bodies.size(); ++b)
    trees_.emplace_back(spaces, order, static_cast<int>(b), options.leafUnknowns);
  for (std::size_t i = 0; i < owners.size(); ++i) {
    const BodyElement place = elementOf(static_cast<Index>(i));
    leaves_.push_back(trees_[static_cast<std::size_t>(place.body)].leafOf(place.element));
  }
  for (Share& share : shares)
    share.abroad.resize(share.unknowns.size());
  for (const LocalCoupling::Entry& entry : between.entries)
    for (const auto& [i, j] :
         {std::pair(entry.row, entry.column), std::pair(entry.column, entry.row)}) {
      const auto [b, own] = owners[at(i)];
      std::vector<int>& abroad = shares[b].abroad[at(own)];
      if (std::find(abroad.begin(), abroad.end(), leafOf(j)) == abroad.end())
        abroad.push_back(leafOf(j));
    }
  for (std::size_t b = 0; b < bodies.size(); ++b)
    Builder(shares[b], bodies[b], trees_[b], options).build();
  if (shares.size() == 1)
    parts_ = std::move(shares.front().parts);
  else
    join(std::move(shares), between);
  addRotations(bodies, local);
}

// Of P = I - r_I qᵀ on displacements:  Pᵀ Z P = Z - q wᵀ - w qᵀ + q (r_I·w) qᵀ
void CompressedOperators::addRotations(const std::vector<Body>& bodies,
                                       const LocalCoupling& local) {
  std::vector<std::size_t> curved;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (bodies[b].space.rotation() != nullptr)
      curved.push_back(b);
  const auto count = 2 * static_cast<Index>(curved.size());
  Rotations rotations{Matrix(size(), count), Matrix(count, count)};
  for (Index k = 0; k < count; k += 2) {
    const std::size_t b = curved[at(k / 2)];
    const Range& own = ranges_[b];
    const Rotation& rotation = *bodies[b].space.rotation();
    const Vector& r = rotation.motion();
    const Vector& q = rotation.functional();
    Matrix x(size(), 1);
    std::copy(r.begin(), r.end(), x.data() + own.first);
    const Matrix image = times(x);
    std::copy(q.begin(), q.end(), rotations.columns.column(k) + own.first);
    double* const w = rotations.columns.column(k + 1);
    std::copy(image.data() + own.first, image.data() + own.last, w + own.first);
    double work = 0;
    for (std::size_t i = 0; i < r.size(); ++i)
      work += r[i] * w[own.first + static_cast<Index>(i)];
    if (!local.rotations.empty())
      std::transform(local.rotations[b].begin(), local.rotations[b].end(), w + further(),
                     std::negate<>());
    rotations.inverse(k, k + 1) = rotations.inverse(k + 1, k) = -1;
    rotations.inverse(k + 1, k + 1) = -work;
  }
  rotations_ = std::move(rotations);
}

// S = [r_I·w, -1; -1, 0]
void CompressedOperators::Rotations::addTo(Matrix& y, const Matrix& x) const {
  for (Index k = 0; k < columns.columns(); k += 2) {
    const double* q = columns.column(k);
    const double* w = columns.column(k + 1);
    for (Index j = 0; j < x.columns(); ++j) {
      const double turn = std::inner_product(q, q + x.rows(), x.column(j), 0.0);
      const double work = std::inner_product(w, w + x.rows(), x.column(j), 0.0);
      for (Index i = 0; i < y.rows(); ++i)
        y(i, j) -= q[i] * (inverse(k + 1, k + 1) * turn + work) + w[i] * turn;
    }
  }
}

/// Unknowns side by side, and matrices that bodies alone do not fill.
void CompressedOperators::join(std::vector<Share> shares, const LocalCoupling& local) {
  std::vector<std::vector<std::pair<Index, double>>> added(leaves_.size());
  for (const LocalCoupling::Entry& entry : local.entries) {
    added[at(entry.row)].emplace_back(entry.column, entry.value);
    added[at(entry.column)].emplace_back(entry.row, entry.value);
  }
  std::vector<Index> places(leaves_.size(), -1);
  const auto placesIn = [&](const std::vector<Index>& unknowns) {
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      places[at(unknowns[i])] = static_cast<Index>(i);
  };
  // one body's, columns at the places of their unknowns
  const auto place = [&](const Share& share, const Matrix& own,
                         const std::vector<Index>& columns, Matrix& all, Index firstRow) {
    for (std::size_t j = 0; j < columns.size(); ++j)
      std::copy_n(own.column(static_cast<Index>(j)), own.rows(),
                  all.column(places[at(share.numbers[at(columns[j])])]) + firstRow);
  };
  const ClusterTree& tree = trees_.front();
  parts_.resize(static_cast<std::size_t>(tree.size()));
  // from the leaves up: children come behind their parents
  for (int c = tree.size() - 1; c >= 0; --c) {
    const auto of = [&](auto& parts) -> auto& {
      return parts[static_cast<std::size_t>(c)];
    };
    const auto child = [&](auto& parts, int k) -> auto& {
      return parts[static_cast<std::size_t>(tree[c].children[k])];
    };
    Part& part = of(parts_);
    for (const Share& share : shares) {
      for (const Index i : of(share.parts).skeleton)
        part.skeleton.push_back(share.numbers[at(i)]);
      for (const Index i : of(share.parts).active)
        if (tree[c].isLeaf())
          part.active.push_back(share.numbers[at(i)]);
    }
    for (int k = 0; k < 2 && !tree[c].isLeaf(); ++k)
      part.active.insert(part.active.end(), child(parts_, k).skeleton.begin(),
                         child(parts_, k).skeleton.end());
    const std::vector<Index>& rows =
        tree[c].isLeaf() ? part.active : child(parts_, 0).skeleton;
    const std::vector<Index>& columns =
        tree[c].isLeaf() ? part.active : child(parts_, 1).skeleton;
    part.weights = Matrix(static_cast<Index>(part.skeleton.size()),
                          static_cast<Index>(part.active.size()));
    part.block =
        Matrix(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
    placesIn(part.active);
    Index row = 0;
    for (const Share& share : shares) {
      const Part& own = of(share.parts);
      place(share, own.weights, own.active, part.weights, row);
      row += static_cast<Index>(own.skeleton.size());
    }
    placesIn(columns);
    row = 0;
    for (const Share& share : shares) {
      const Part& own = of(share.parts);
      place(share, own.block,
            tree[c].isLeaf() ? own.active : child(share.parts, 1).skeleton, part.block,
            row);
      row += own.block.rows();
    }
    for (const Index i : part.active)
      places[at(i)] = -1;
    placesIn(rows);
    for (std::size_t j = 0; j < columns.size(); ++j)
      for (const auto& [other, value] : added[at(columns[j])])
        if (places[at(other)] >= 0)
          part.block(places[at(other)], static_cast<Index>(j)) += value;
    for (const Index i : rows)
      places[at(i)] = -1;
    for (Share& share : shares) {
      of(share.parts).weights = Matrix();
      of(share.parts).block = Matrix();
    }
  }
}

// Upwards what leaves each cluster, downwards what comes to it from outside.
Matrix CompressedOperators::times(const Matrix& x) const {
  const SerialBlas serial;
  const Index columns = x.columns();
  Matrix result(x.rows(), columns);
  std::vector<Matrix> out(parts_.size());
  std::vector<Matrix> in(parts_.size());
  const auto active = [&](int c) {
    const Cluster& cluster = tree()[c];
    return cluster.isLeaf() ? rowsOf(x, part(c).active)
                            : stacked(out[static_cast<std::size_t>(cluster.children[0])],
                                      out[static_cast<std::size_t>(cluster.children[1])]);
  };
  for (int l = tree().levels() - 1; l > 0; --l) {
    const std::vector<int>& level = tree().level(l);
#pragma omp parallel for schedule(dynamic, 1)
    for (std::size_t k = 0; k < level.size(); ++k)
      out[static_cast<std::size_t>(level[k])] =
          product(part(level[k]).weights, active(level[k]));
  }
  for (int l = 0; l < tree().levels(); ++l) {
    const std::vector<int>& level = tree().level(l);
#pragma omp parallel for schedule(dynamic, 1)
    for (std::size_t k = 0; k < level.size(); ++k) {
      const int c = level[k];
      const Part& own = part(c);
      Matrix all(static_cast<Index>(own.active.size()), columns);
      if (l > 0)
        addTransposedProduct(1, own.weights, in[static_cast<std::size_t>(c)], all);
      if (tree()[c].isLeaf()) {
        addProduct(1, own.block, rowsOf(x, own.active), all);
        putRows(all, own.active, result);
        continue;
      }
      const auto first = static_cast<std::size_t>(tree()[c].children[0]);
      const auto second = static_cast<std::size_t>(tree()[c].children[1]);
      in[first] = rowsBetween(all, 0, out[first].rows());
      in[second] = rowsBetween(all, out[first].rows(), all.rows());
      addProduct(1, own.block, out[second], in[first]);
      addTransposedProduct(1, own.block, out[first], in[second]);
    }
  }
  rotations_.addTo(result, x);
  return result;
}

CompressedOperators::Ranks CompressedOperators::ranks(int level) const {
  Ranks ranks;
  for (const int c : tree().level(level)) {
    const auto k = static_cast<Index>(part(c).skeleton.size());
    ranks.largest = std::max(ranks.largest, k);
    ranks.mean +=
        static_cast<double>(k) / static_cast<double>(tree().level(level).size());
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
