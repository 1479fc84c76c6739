#include "bem/operators/Entries.hpp"

#include "bem/operators/LocalTerms.hpp"
#include "bem/operators/TileBlocks.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

/// Unknowns of some elements, and the elements that share them.
struct Unknowns {
  std::vector<int> elements;        ///< the given ones and those before them, each once
  std::vector<Index> density;       ///< by unknown of the space: its place, or -1
  std::vector<Index> displacement;  ///< the same
  Index densities = 0;
  Index displacements = 0;

  Unknowns(const Space& space, const std::vector<int>& given)
      : density(static_cast<std::size_t>(space.densities()), -1),
        displacement(static_cast<std::size_t>(space.displacements()), -1) {
    for (const int e : given) {
      const Element& element = space.mesh()[e];
      for (int k = 0; k < 2 * element.densities; ++k)
        density[static_cast<std::size_t>(space.density(e, 0, k))] = densities++;
      for (int k = 0; k < 2 * element.degree; ++k)
        displacement[static_cast<std::size_t>(space.displacement(e, 0, k))] =
            displacements++;
      elements.push_back(e);
      elements.push_back(element.previous);
    }
    std::sort(elements.begin(), elements.end());
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  }
  Index ofDensity(Index i) const { return density[static_cast<std::size_t>(i)]; }
  Index ofDisplacement(Index i) const {
    return displacement[static_cast<std::size_t>(i)];
  }
};

void addTo(Matrix& matrix, Index row, Index column, double value) {
  if (row >= 0 && column >= 0)
    matrix(row, column) += value;
}

/// Adds what a tile gives.
void addTile(const Space& space, const Tile& tile, const TileBlocks& blocks,
             const Unknowns& tests, const Unknowns& trials, EntryBlocks& out) {
  const int f = tile.trial();
  const ElementRun& run = tile.run();
  const Element& element = space.mesh()[f];
  const Index densities = space.density(run.first, 0, 0);
  const Index nodes = blocks.displacements() - 2;
  const auto displacement = [&](Index k) {
    return k < nodes ? space.displacement(run.first, 0, 0) + k
                     : space.displacement(run.last - 1, 1, 0) + k - nodes;
  };
  for (int c = 0; c < 2; ++c) {
    for (int i = 0; i < element.densities; ++i)
      for (Index k = 0; k < blocks.densities(); ++k)
        addTo(out.singleLayer, tests.ofDensity(densities + k),
              trials.ofDensity(space.density(f, i, c)), blocks.singleLayer(i, c)[k]);
    for (int j = 0; j <= element.degree; ++j) {
      const Index column = trials.ofDisplacement(space.displacement(f, j, c));
      for (Index k = 0; k < blocks.densities(); ++k)
        addTo(out.doubleLayer, tests.ofDensity(densities + k), column,
              blocks.doubleLayer(j, c)[k]);
      const double slope = DisplacementBasis::slope(j);
      for (Index k = 0; k < blocks.displacements(); ++k)
        addTo(out.hypersingular, tests.ofDisplacement(displacement(k)), column,
              slope * blocks.slopeLayer(std::max(j - 1, 0), c)[k]);
    }
  }
}

/// Points of an element and its displacement functions there, times weights.
struct Samples {
  std::vector<Complex> offsets;  ///< from the element's middle
  std::vector<Complex> tangents;
  std::vector<std::array<double, largestDegree + 1>> values;

  Samples(const Element& element, int order) {
    const Rule& rule = gaussLegendre(order + degreeShare(element.degree));
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      offsets.push_back(asComplex(element.curve.fromMiddle(rule.points[q])));
      tangents.push_back(asComplex(element.curve.tangent(rule.points[q])));
      values.emplace_back();
      DisplacementBasis::values(element.degree, rule.points[q], values.back().data());
      for (double& value : values.back())
        value *= element.half * rule.weights[q];
    }
  }
};

/// The functions φ_k of an element stand on it and, at its nodes, on a neighbour: the
/// places of these in (the element before, itself, the one behind).
struct Support {
  int first;
  int last;
  explicit Support(int k) : first(k == 0 ? 0 : 1), last(k == 1 ? 2 : 1) {}
};

/// Which of the elements around e are far from which around f.
class Surroundings {
 public:
  Surroundings(const Mesh& mesh, int e, int f) {
    const int tests[3] = {mesh[e].previous, e, mesh[e].next};
    const int trials[3] = {mesh[f].previous, f, mesh[f].next};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const Vec2 w = mesh.difference(mesh.at(tests[i], 0), mesh.at(trials[j], 0));
        FarOrder order;
        far_[i][j] = !isNear(mesh, tests[i], trials[j], w, order);
        if (i == 1 && j == 1)
          order_ = order;
      }
  }
  FarOrder order() const { return order_; }
  bool areFar(int k, int l) const {
    for (int i = Support(k).first; i <= Support(k).last; ++i)
      for (int j = Support(l).first; j <= Support(l).last; ++j)
        if (!far_[i][j])
          return false;
    return true;
  }
  /// Nothing but bubbles is farther than the nodes' functions.
  bool anyFar() const { return far_[1][1]; }

 private:
  bool far_[3][3] = {};
  FarOrder order_;
};

/// W of far functions with its own kernel.
class FarHypersingular {
 public:
  FarHypersingular(const Space& space, const Lame& lame, const Unknowns& tests,
                   const Unknowns& trials)
      : space_(space),
        lame_(lame),
        tests_(tests),
        trials_(trials),
        values_(tests.displacements, trials.displacements),
        isFar_(static_cast<std::size_t>(tests.displacements * trials.displacements)) {}

  /// Adds what the functions of e and f have on these two elements.
  void add(int e, int f) {
    const Mesh& mesh = space_.mesh();
    const Surroundings around(mesh, e, f);
    if (!around.anyFar())
      return;
    constexpr int forSquares = 2;  // 1/w² asks for a bit more than log w
    const Element& x = mesh[e];
    const Element& y = mesh[f];
    const Samples outer(x, around.order().outer + forSquares);
    const Samples inner(y, around.order().inner + forSquares);
    const Complex w = asComplex(mesh.difference(mesh.at(e, 0), mesh.at(f, 0)));
    for (std::size_t p = 0; p < outer.offsets.size(); ++p)
      for (std::size_t q = 0; q < inner.offsets.size(); ++q) {
        const Complex offset = outer.offsets[p] - inner.offsets[q];
        const Block kernel =
            hypersingularBlock(lame_, w + offset, outer.tangents[p], inner.tangents[q]);
        for (int k = 0; k <= x.degree; ++k)
          for (int l = 0; l <= y.degree; ++l)
            if (around.areFar(k, l))
              put(space_.displacement(e, k, 0), space_.displacement(f, l, 0),
                  outer.values[p][static_cast<std::size_t>(k)] *
                      inner.values[q][static_cast<std::size_t>(l)] * kernel);
      }
  }

  /// Puts what was added in place of what is there.
  void replaceIn(Matrix& out) const {
    for (Index j = 0; j < out.columns(); ++j)
      for (Index i = 0; i < out.rows(); ++i)
        if (isFar_[at(i, j)])
          out(i, j) = values_(i, j);
  }

 private:
  std::size_t at(Index i, Index j) const {
    return static_cast<std::size_t>(i + j * values_.rows());
  }
  void put(Index test, Index trial, const Block& block) {
    const Index row = tests_.ofDisplacement(test);
    const Index column = trials_.ofDisplacement(trial);
    if (row < 0 || column < 0)
      return;
    addBlock(values_, {0, values_.rows()}, row, column, block);
    for (Index j = column; j < column + 2; ++j)
      isFar_[at(row, j)] = isFar_[at(row + 1, j)] = true;
  }

  const Space& space_;
  Lame lame_;
  const Unknowns& tests_;
  const Unknowns& trials_;
  Matrix values_;
  std::vector<bool> isFar_;
};

}  // namespace

EntryBlocks entries(const Space& space, const Lame& lame,
                    const std::vector<int>& testElements,
                    const std::vector<int>& trialElements) {
  const Unknowns tests(space, testElements);
  const Unknowns trials(space, trialElements);
  EntryBlocks out{Matrix(tests.densities, trials.densities),
                  Matrix(tests.densities, trials.displacements),
                  Matrix(tests.displacements, trials.displacements)};
  const ElementRuns runs(space.mesh());
  Tile tile(runs);
  TileBlocks blocks(space, lame);
  FarHypersingular far(space, lame, tests, trials);
  for (auto e = tests.elements.begin(); e != tests.elements.end();) {
    const int r = runs.runOf(*e);
    for (const int f : trials.elements) {
      tile.evaluate(f, r, {runs[r].first, runs[r].last});
      blocks.evaluate(tile);
      addTile(space, tile, blocks, tests, trials, out);
    }
    while (e != tests.elements.end() && runs.runOf(*e) == r)
      ++e;
  }
  for (const int e : tests.elements)
    for (const int f : trials.elements)
      far.add(e, f);
  far.replaceIn(out.hypersingular);
  const auto add = [&](Index test, Index trial, const Block& block) {
    const Index row = tests.ofDensity(test);
    const Index column = trials.ofDisplacement(trial);
    if (row >= 0 && column >= 0)
      addBlock(out.doubleLayer, {0, tests.densities}, row, column, block);
  };
  addHalfMass(space, tests.elements, add);
  addEdgeEnds(space, lame, tests.elements, trials.elements, add);
  return out;
}

}  // namespace epafi::bem
