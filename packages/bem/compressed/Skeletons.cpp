#include "bem/compressed/Skeletons.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/compressed/CoupledEntries.hpp"
#include "bem/compressed/NearBlocks.hpp"
#include "bem/compressed/ProxyRows.hpp"
#include "bem/mesh/Surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace epafi::bem {

namespace {

/// An interpolation of some places among all, of which others stay as they are.
Interpolation spread(Interpolation some, const std::vector<Index>& places,
                     const std::vector<Index>& staying) {
  for (std::vector<Index>* own : {&some.skeleton, &some.rest})
    for (Index& place : *own)
      place = places[place];
  if (staying.empty())
    return some;
  some.skeleton.insert(some.skeleton.end(), staying.begin(), staying.end());
  Matrix weights(some.rows(), some.weights.columns());
  for (Index j = 0; j < weights.columns(); ++j)
    std::copy_n(some.weights.column(j), some.weights.rows(), weights.column(j));
  some.weights = std::move(weights);
  return some;
}

class Builder {
 public:
  Builder(BodyShare& out, const Space& space, const Kernel& kernel,
          const ClusterTree& tree, const Compression& options, const Subtrees& subtrees)
      : out_(out),
        tree_(tree),
        subtrees_(subtrees),
        space_(space),
        kernel_(kernel),
        options_(options),
        added_(out.unknowns.size()),
        largestAdded_(out.unknowns.size()) {
    for (const Entry& entry : out.entries) {
      added_[entry.row].push_back({entry.column, entry.value});
      if (entry.row != entry.column)
        added_[entry.column].push_back({entry.row, entry.value});
      for (const Index i : {entry.row, entry.column})
        largestAdded_[i] = std::max(largestAdded_[i], std::abs(entry.value));
    }
  }

  void build() {
    out_.parts.resize(tree_.size());
    fillLeaves();
    if (!subtrees_.roots().empty())
      own_ = std::make_unique<const NearBlocks>(space_, kernel_, tree_, ownElements(),
                                                allElements());
    for (int l = tree_.levels() - 1; l >= 0; --l) {
      std::vector<int> mine;
      for (const int c : tree_.level(l)) {
        if (!tree_[c].isLeaf())
          gather(c);
        if (subtrees_.isMine(c))
          mine.push_back(c);
        if (subtrees_.isEverybodys(c) && top_ == nullptr)
          makeTop(l);
      }
      parallelFor(
          {static_cast<Index>(mine.size()), workOf(mine)}, [&] { return Worker(*this); },
          [&](Worker& worker, Index k) {
            const int c = mine[at(k)];
            worker.fillBlock(c);
            if (l > 0 && !tree_[c].isEmpty())
              worker.compress(c);
          });
      exchangeSkeletons(l);
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
          proxies_(builder.space_, builder.kernel_, builder.out_.unknowns,
                   builder.options_.ratio, builder.options_.tolerance),
          places_(builder.out_.unknowns.size(), -1) {
      if (builder.own_ != nullptr)
        own_.emplace(builder.space_, builder.kernel_, *builder.own_,
                     builder.out_.unknowns);
      if (builder.top_ != nullptr)
        top_.emplace(builder.space_, builder.kernel_, *builder.top_,
                     builder.out_.unknowns);
    }

    void fillBlock(int c) {
      const Cluster& cluster = builder_.tree_[c];
      ClusterPart& part = builder_.part(c);
      if (cluster.isLeaf()) {
        part.block = entries(c).symmetric(part.active);
        addLocal(part.active, part.active, part.block);
      } else {
        part.block = entriesOf(c, builder_.part(cluster.children[0]).skeleton,
                               builder_.part(cluster.children[1]).skeleton);
      }
    }

    void compress(int c) {
      ClusterPart& part = builder_.part(c);
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
      const Matrix entries = entriesOf(c, near, active);
      const Matrix fields = proxies_(builder_.tree_, c, active);
      const auto weight = [&](Index unknown) { return builder_.weightOf(unknown, c); };
      const double stiffness = std::sqrt(builder_.kernel_.stiffness());
      // a point's share of the circle
      const double share =
          stiffness * std::sqrt(2 * 3.14159265358979323846 * options().ratio * radius /
                                proxies_.points());
      const Index first = fields.rows() + builder_.space_.components();
      Matrix a(first + entries.rows(), n);
      Vector sizes;
      double largest = 0;
      for (const Index row : near)
        sizes.push_back(weight(row));
      for (Index j = 0; j < n; ++j) {
        const Index unknown = active[j];
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
          a(first + i, j) = own * sizes[i] * entries(i, j);
      }
      Interpolation kept;
      if (n > 0)
        kept = interpolateColumns(std::move(a), options().tolerance * std::sqrt(largest));
      part.weights = spread(std::move(kept), places, staying);
      for (const Index k : part.weights.skeleton)
        part.skeleton.push_back(part.active[k]);
      // from scaled columns to those of the unknowns
      Vector own;
      for (const Index unknown : part.active)
        own.push_back(weight(unknown));
      Matrix& weights = part.weights.weights;
      for (Index j = 0; j < weights.columns(); ++j)
        for (Index i = 0; i < weights.rows(); ++i)
          weights(i, j) *= own[part.weights.skeleton[i]] / own[part.weights.rest[j]];
    }

   private:
    const Compression& options() const { return builder_.options_; }

    CoupledEntries& entries(int c) {
      return builder_.subtrees_.isEverybodys(c) ? *top_ : *own_;
    }

    Matrix entriesOf(int c, const std::vector<Index>& rows,
                     const std::vector<Index>& columns) {
      Matrix result = entries(c)(rows, columns);
      addLocal(rows, columns, result);
      return result;
    }

    void addLocal(const std::vector<Index>& rows, const std::vector<Index>& columns,
                  Matrix& result) {
      const auto& added = builder_.added_;
      for (std::size_t i = 0; i < rows.size(); ++i)
        places_[rows[i]] = static_cast<Index>(i);
      for (std::size_t j = 0; j < columns.size(); ++j)
        for (const Added& entry : added[columns[j]])
          if (places_[entry.other] >= 0)
            result(places_[entry.other], static_cast<Index>(j)) += entry.value;
      for (const Index row : rows)
        places_[row] = -1;
    }

    const Builder& builder_;
    std::optional<CoupledEntries> own_;
    std::optional<CoupledEntries> top_;
    ProxyRows proxies_;
    std::vector<Index> places_;
  };

  /// What makes unknowns of a cluster comparable: functions of size one in L² of the surface, densities in
  /// stresses of Young's modulus, displacements over the cluster's radius.  Elements much shorter
  /// than the cluster's unknowns are apart count as longer; with their own sizes graded meshes
  /// would have larger ranks.
  double weightOf(Index unknown, int c) const {
    const double radius = tree_[c].radius;
    const double shortest = 4 * radius / static_cast<double>(part(c).active.size());
    const double stiffness = std::sqrt(kernel_.stiffness());
    const Mesh& mesh = space_.mesh();
    const Unknown& u = out_.unknowns[unknown];
    const Element& element = mesh[u.element];
    const double around = std::sqrt(aroundOf(u));
    const double own = 2 * integratedHalf(mesh, u.element);
    if (u.local < 0) {
      const double added = largestAdded_[unknown];
      return stiffness * std::sqrt(std::max(own, shortest)) / (added > 0 ? added : 1) *
             around;
    }
    const LocalFunctions local(space_, u.element);
    if (u.local >= local.displacements) {
      const int i = (u.local - local.displacements) / local.components;
      return stiffness * std::sqrt(std::max(own, shortest) * (2 * i + 1)) / own / around;
    }
    const double size =
        u.isNode ? 0.5 * own + integratedHalf(mesh, element.previous) : own;
    // ∫ φ_k² dt on [-1, 1] over that of a hat
    const int k = u.local / local.components;
    const double square = k < 2 ? 1 : 3.0 / ((2 * k + 1) * (2 * k - 3));
    return radius / stiffness / std::sqrt(std::max(size, shortest) * square) / around;
  }

  /// What surfaces have more than lines: 2πr around an axis.
  double aroundOf(const Unknown& u) const {
    const Mesh& mesh = space_.mesh();
    const int e = mesh.isAxis(u.element) ? mesh[u.element].previous : u.element;
    return mesh.measure(e, 0) / mesh[e].half;
  }

  ClusterPart& part(int c) const { return out_.parts[c]; }

  /// Of entries with what is near, and of the triangle of a few times as many rows [ns].
  double workOf(const std::vector<int>& clusters) const {
    constexpr double ofEntry = 50;
    double work = 0;
    for (const int c : clusters) {
      const auto n = static_cast<double>(part(c).active.size());
      work += n * n * (ofEntry + workOfFlops(8 * n));
    }
    return work;
  }

  void fillLeaves() {
    for (std::size_t i = 0; i < out_.unknowns.size(); ++i)
      part(tree_.leafOf(out_.unknowns[i].element))
          .active.push_back(static_cast<Index>(i));
  }

  std::vector<char> allElements() const {
    return std::vector<char>(space_.mesh().size(), 1);
  }
  void mark(const std::vector<Index>& unknowns, std::vector<char>& elements) const {
    for (const Index i : unknowns) {
      const Unknown& unknown = out_.unknowns[i];
      elements[unknown.element] = 1;
      elements[space_.mesh()[unknown.element].previous] = 1;
    }
  }
  /// Those that unknowns of this process's subtrees live on.
  std::vector<char> ownElements() const {
    std::vector<char> elements(space_.mesh().size());
    for (int c = 0; c < tree_.size(); ++c)
      if (tree_[c].isLeaf() && subtrees_.isMine(c))
        mark(part(c).active, elements);
    return elements;
  }

  // Clusters from this level upwards have what roots below have left, and roots that are
  // leaves.
  void makeTop(int level) {
    if (subtrees_.roots().empty()) {
      top_ = std::make_unique<const NearBlocks>(space_, kernel_, tree_, allElements(),
                                                allElements());
      return;
    }
    std::vector<char> elements(space_.mesh().size());
    for (const int root : subtrees_.roots())
      mark(tree_[root].level > level ? part(root).skeleton : part(root).active, elements);
    top_ = std::make_unique<const NearBlocks>(space_, kernel_, tree_, elements, elements);
  }

  void exchangeSkeletons(int level) {
    if (subtrees_.roots().empty())
      return;
    // the skeleton's size and itself; there is room for all that is active
    std::vector<Vector> lists(tree_.size());
    const auto forLists = [&](const auto& action) {
      for (const int c : tree_.level(level))
        if (!subtrees_.isEverybodys(c))
          action(c, lists[c]);
    };
    forLists([&](int c, Vector& list) {
      const std::vector<Index>& skeleton = part(c).skeleton;
      list.push_back(static_cast<double>(skeleton.size()));
      list.insert(list.end(), skeleton.begin(), skeleton.end());
      list.resize(part(c).active.size() + 1);
    });
    constexpr double kind = 5;
    subtrees_.exchangeNumbers(kind, level, [&](const auto& action) {
      forLists([&](int c, Vector& list) {
        for (double& number : list)
          action(c, number);
      });
    });
    forLists([&](int c, const Vector& list) {
      const auto size = static_cast<std::ptrdiff_t>(list.front());
      part(c).skeleton.assign(list.begin() + 1, list.begin() + 1 + size);
    });
  }

  bool actsOutside(Index unknown, int c) const {
    const std::vector<int>& leaves = out_.abroad[unknown];
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
    const Unknown& u = out_.unknowns[unknown];
    const int i = u.local - LocalFunctions(space_, u.element).displacements;
    const bool isConstant = i >= 0 && i < space_.components();
    return {isConstant ? i : 0, isConstant ? 2 * space_.mesh().measure(u.element, 0) : 0};
  }

  /// Does an unknown's function reach into the circle of radius r around a cluster?
  bool reaches(Index unknown, int c, double r) const {
    const Mesh& mesh = space_.mesh();
    const Unknown& u = out_.unknowns[unknown];
    const auto touches = [&](int e) {
      return !mesh.isAxis(e) &&
             length(tree_.fromCentre(c, mesh.at(e, 0))) - mesh[e].half < r;
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

  BodyShare& out_;
  const ClusterTree& tree_;
  const Subtrees& subtrees_;
  const Space& space_;
  const Kernel& kernel_;
  const Compression& options_;
  std::unique_ptr<const NearBlocks> own_;  ///< of this process's subtrees
  std::unique_ptr<const NearBlocks> top_;  ///< of clusters that are everybody's
  std::vector<std::vector<Added>> added_;
  Vector largestAdded_;
};

}  // namespace

void skeletonise(BodyShare& share, const Space& space, const Kernel& kernel,
                 const ClusterTree& tree, const Compression& options,
                 const Subtrees& subtrees) {
  Builder(share, space, kernel, tree, options, subtrees).build();
}

}  // namespace epafi::bem
