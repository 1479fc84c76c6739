#include "bem/compressed/NearBlocks.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Parallel.hpp"
#include "bem/mesh/Surfaces.hpp"
#include "bem/operators/FarBlocks.hpp"
#include "bem/operators/PairColumns.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace epafi::bem {

namespace {

/// One pair by parts: what a tile says of it.
class PairByParts {
 public:
  PairByParts(const Space& space, const Kernel& kernel)
      : space_(space), runs_(space.mesh()), pairs_(kernel.pairs(space)) {}

  /// Functions of e by functions of f, row by row.
  // NOLINTNEXTLINE(readability-function-cognitive-complexity): loops that copy
  void evaluate(int e, int f, double* out) {
    const int r = runs_.runOf(e);
    pairs_->evaluate(runs_, f, r, {e, e + 1});
    const Element& x = space_.mesh()[e];
    const Element& y = space_.mesh()[f];
    const LocalFunctions rows(space_, e);
    const LocalFunctions columns(space_, f);
    const int components = rows.components;
    const int width = columns.size();
    const ElementLanes& run = runs_[r];
    const Index densities = space_.density(e, 0, 0) - space_.density(run.first, 0, 0);
    const Index start =
        space_.displacement(e, 0, 0) - space_.displacement(run.first, 0, 0);
    // the node behind comes after the bubbles
    const Index end = start + components * x.degree;
    const auto displacement = [&](int a) {
      return rows.isNode(a, 0)   ? start + a
             : rows.isNode(a, 1) ? end + a - components
                                 : start + a - components;
    };
    for (int c = 0; c < components; ++c) {
      for (int i = 0; i < y.densities; ++i) {
        const int column = columns.density(i, c);
        for (int a = 0; a < rows.densities; ++a)
          out[(rows.displacements + a) * width + column] =
              -pairs_->singleLayer(i, c)[densities + a];
        for (int a = 0; a < rows.displacements && e != f; ++a)
          out[a * width + column] = pairs_->transposed(i, c)[displacement(a)];
      }
      for (int j = 0; j <= y.degree; ++j) {
        const int column = columns.displacement(j, c);
        for (int a = 0; a < rows.densities; ++a)
          out[(rows.displacements + a) * width + column] =
              pairs_->doubleLayer(j, c)[densities + a];
        const auto [from, scale] = pairs_->hypersingular(j, c);
        for (int a = 0; a < rows.displacements; ++a)
          out[a * width + column] = scale * from[displacement(a)];
      }
    }
    for (int a = 0; a < rows.displacements && e == f; ++a)
      for (int b = 0; b < rows.densities; ++b)
        out[a * width + rows.displacements + b] =
            out[(rows.displacements + b) * width + a];
  }

 private:
  const Space& space_;
  ElementRuns runs_;
  std::unique_ptr<PairColumns> pairs_;
};

/// Which functions of a pair have all their elements far from each other.
class Distances {
 public:
  Distances(const Space& space, int e, int f) : x_(space, e), y_(space, f) {
    const Mesh& mesh = space.mesh();
    const int tests[3] = {mesh[e].previous, e, mesh[e].next};
    const int trials[3] = {mesh[f].previous, f, mesh[f].next};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const Vec2 w = mesh.offset(tests[i], trials[j]);
        far_[i][j] = mesh.isAxis(tests[i]) || mesh.isAxis(trials[j]) ||
                     nearness(mesh, tests[i], trials[j], w).isFar();
      }
  }
  /// Of the elements themselves.
  bool areFar() const { return far_[1][1]; }
  /// Of local functions.
  bool areFar(int a, int b) const {
    for (int i = first(x_, a); i <= last(x_, a); ++i)
      for (int j = first(y_, b); j <= last(y_, b); ++j)
        if (!far_[i][j])
          return false;
    return true;
  }

 private:
  static int first(const LocalFunctions& of, int a) { return of.isNode(a, 0) ? 0 : 1; }
  static int last(const LocalFunctions& of, int a) { return of.isNode(a, 1) ? 2 : 1; }

  LocalFunctions x_;
  LocalFunctions y_;
  bool far_[3][3] = {};
};

}  // namespace

NearBlocks::NearBlocks(const Space& space, const Kernel& kernel, const ClusterTree& tree,
                       const std::vector<char>& first, const std::vector<char>& second)
    : space_(space), mesh_(space.mesh()) {
  findPairs(tree, first, second);
  struct Workspace {
    PairByParts byParts;
    std::unique_ptr<FarBlocks> far;
  };
  constexpr double ofEntry = 20;  // ns
  parallelFor(
      {mesh_.size(), ofEntry * static_cast<double>(values_.size()), 16},
      [&] {
        return Workspace{{space, kernel}, kernel.far(space)};
      },
      [&](Workspace& own, Index row) {
        const int e = asInt(row);
        for (const Pair& pair : pairs_[at(row)]) {
          const int f = pair.element;
          double* out = values_.data() + pair.start;
          own.byParts.evaluate(e, f, out);
          const Distances distances(space_, e, f);
          if (!distances.areFar())
            continue;
          own.far->evaluate({{e, mesh_.offset(e, f)}}, f);
          const int rows = LocalFunctions(space_, e).size();
          const int columns = LocalFunctions(space_, f).size();
          for (int a = 0; a < rows; ++a)
            for (int b = 0; b < columns; ++b)
              if (distances.areFar(a, b))
                out[a * columns + b] = own.far->lane(a, b)[0];
        }
      });
}

void NearBlocks::measure() {
  for (int e = 0; e < mesh_.size(); ++e) {
    const Element& element = mesh_[e];
    const double before = integratedHalf(mesh_, element.previous);
    const double behind = integratedHalf(mesh_, element.next);
    hoods_.push_back({mesh_.scaledPoint(e, 0),
                      element.half + 2 * std::max(before, behind),
                      std::max({element.half, before, behind})});
    sizes_.push_back(LocalFunctions(space_, e).size());
  }
}

std::vector<NearBlocks::Hood> NearBlocks::around(const ClusterTree& tree) const {
  std::vector<Hood> around(tree.size());
  for (int c = 0; c < tree.size(); ++c)
    for (int k = tree[c].first; k < tree[c].last; ++k) {
      const int e = tree.element(k);
      Hood& all = around[c];
      all.half = std::max(all.half, hoods_[e].half);
      all.radius = std::max(
          all.radius, hoods_[e].radius + length(tree.fromCentre(c, mesh_.at(e, 0))));
    }
  return around;
}

void NearBlocks::findPairs(const ClusterTree& tree, const std::vector<char>& first,
                           const std::vector<char>& second) {
  measure();
  pairs_.resize(hoods_.size());
  std::size_t next = 0;
  const auto addPair = [&](int e, int f) {
    const bool isAsked = (first[e] & second[f]) != 0 || (first[f] & second[e]) != 0;
    if (!isAsked || isFullyFar(e, f) || mesh_.isAxis(e) || mesh_.isAxis(f))
      return;
    pairs_[e].push_back({f, next});
    next += static_cast<std::size_t>(sizes_[e] * sizes_[f]);
  };
  const std::vector<Hood> hoods = around(tree);
  const auto areFar = [&](int a, int b) {
    return length(tree.between(a, b)) > clearly * clearly *
                                            (hoods[a].radius + hoods[b].radius +
                                             std::max(hoods[a].half, hoods[b].half));
  };
  // a leaf against all that is not far from it
  for (const int leaf : tree.cut(tree.levels() - 1)) {
    if (tree[leaf].isEmpty())
      continue;
    std::vector<int> waiting = {0};
    while (!waiting.empty()) {
      const int c = waiting.back();
      waiting.pop_back();
      if (tree[c].isEmpty() || tree[c].last <= tree[leaf].first || areFar(leaf, c))
        continue;
      if (!tree[c].isLeaf()) {
        waiting.insert(waiting.end(), {tree[c].children[0], tree[c].children[1]});
        continue;
      }
      for (int k = tree[leaf].first; k < tree[leaf].last; ++k)
        for (int l = std::max(k, tree[c].first); l < tree[c].last; ++l) {
          const auto [e, f] = std::minmax({tree.element(k), tree.element(l)});
          addPair(e, f);
        }
    }
  }
  for (std::vector<Pair>& pairs : pairs_)
    std::sort(pairs.begin(), pairs.end(),
              [](const Pair& a, const Pair& b) { return a.element < b.element; });
  values_.resize(next);
}

NearBlocks::View NearBlocks::of(int e, int f) const {
  const std::vector<Pair>& pairs = pairs_[std::min(e, f)];
  const int other = std::max(e, f);
  const auto found = std::lower_bound(
      pairs.begin(), pairs.end(), other,
      [](const Pair& pair, int element) { return pair.element < element; });
  if (found == pairs.end() || found->element != other)
    throw std::logic_error(
        message("elements ", e, " and ", f, " have no block among the near ones"));
  const double* data = values_.data() + found->start;
  const Index columns = sizes_[other];
  return e <= f ? View{data, columns, 1} : View{data, 1, columns};
}

}  // namespace epafi::bem
