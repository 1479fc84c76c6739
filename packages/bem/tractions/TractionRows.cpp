#include "bem/tractions/TractionRows.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/base/Error.hpp"
#include "bem/base/Parallel.hpp"
#include "bem/kernel/Elasticity.hpp"
#include "bem/moments/ElementPotential.hpp"
#include "bem/moments/ElementRuns.hpp"
#include "bem/operators/FarBlocks.hpp"
#include "bem/operators/Kernel.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace epafi::bem {

namespace {

/// Gauss points, beside those of polynomials, beyond which a source's field on an element
/// would need too many Legendre moments.
constexpr int smoothOrderOfMoments = 7;

/// P_j e_c on a source: as a density, or as a displacement's derivative by arc length.
struct Component {
  enum class Kind { Density, Slope };
  Kind kind;
  int element;
  int j;
  int c;
};

/// Eight points of the test element.
struct TestPoints {
  ComplexLanes normal;
  AlignedLane root;  ///< of the weights by arc length
};

/// Values there of some components, all on one source.
struct Sampling {
  const Lame& lame;
  const ElementPotential& source;
  const Component* first;
  const Component* last;
  const TestPoints& points;
  ComplexLanes* values;

  template <Division>
  EPAFI_INLINE void run() const {
    const ComplexPack normal = points.normal.load();
    SumsOf<ComplexPack> sums;
    for (const Component* of = first; of != last; ++of) {
      if (of == first || of->j != (of - 1)->j) {
        const ElementPotential::Values unit = source.of(of->j);
        sums = {conj(unit.overConj), unit.overConj, unit.cubic};
      }
      const SumsOf<ComplexPack> own = (of->c == 0 ? Complex(1, 0) : Complex(0, 1)) * sums;
      values[of - first].store(load(points.root.lane) *
                               (of->kind == Component::Kind::Slope
                                    ? hypersingular(lame, normal, own)
                                    : adjointDoubleLayer(lame, normal, own)));
    }
  }
};

/// Of one element E.
class ElementRows {
 public:
  ElementRows(const Space& space, const Lame& lame, const ElementRuns& runs, int element,
              int moments, TractionForm form)
      : space_(space),
        mesh_(space.mesh()),
        lame_(lame),
        element_(element),
        moments_(moments),
        far_(static_cast<std::size_t>(mesh_.size())) {
    const bool isExact = form == TractionForm::Exact;
    if (isExact)  // what far sources have beyond these is 1e-12
      moments_ = std::max(moments_, 2 * smoothOrderOfMoments);
    findFar(runs, isExact ? smoothOrderOfMoments : largestSmoothOrder);
    listComponents();
    const GradedRule rule = ruleOf(form);
    std::array<Matrix, 2> samples = sample(rule);
    const Matrix tests = weightedTests(rule);
    near_ = Matrix(2 * moments_, static_cast<Index>(components_.size()));
    for (Index a = 0; a < 2; ++a) {
      const Matrix found = transposedProduct(tests, samples[at(a)]);
      for (Index s = 0; s < near_.columns(); ++s)
        for (Index i = 0; i < moments_; ++i)
          near_(2 * i + a, s) = found(i, s);
      if (isExact)
        addProduct(-1, tests, found, samples[at(a)]);
    }
    if (isExact)
      beyond_ = triangularFactor(stacked(samples[0], samples[1]));
    addHalf();
  }

  int element() const { return element_; }
  int moments() const { return moments_; }
  Index columns() const { return near_.rows() + beyond_.rows(); }
  bool isFar(int f) const { return far_[static_cast<std::size_t>(f)] != 0; }

  /// Adds what is near to the columns from `first` on.
  void addNear(Index first, TractionRows& out) const {
    addComponents(near_, first, out);
    addComponents(beyond_, first + near_.rows(), out);
  }

  /// Adds a far source, a lane of some blocks.
  void addFar(int f, const FarBlocks& blocks, int lane, Index first,
              TractionRows& out) const {
    const Element& y = mesh_[f];
    const bool areNodesFar[] = {isFar(f, 0), isFar(f, 1)};
    for (int row = 0; row < 2 * moments_; ++row) {
      const int moment = row / 2;
      const double scale = std::sqrt((moment + 0.5) / mesh_[element_].half);
      double* column = out.rows.column(first + row);
      double* densities = column + space_.displacements() + space_.density(f, 0, 0);
      const auto value = [&](int b) { return scale * blocks.lane(row, b)[lane]; };
      for (int k = 0; k <= y.degree; ++k)
        for (int c = 0; c < 2 && (k > 1 || areNodesFar[k]); ++c)
          column[space_.displacement(f, k, c)] += value(2 * k + c);
      for (int b = 0; b < 2 * y.degree; ++b)
        densities[b] = value(2 * (y.degree + 1) + b);
    }
  }

 private:
  using Kind = Component::Kind;

  /// φ_k of f with all of its elements: FarBlocks has W φ of functions that vanish at their ends.
  bool isFar(int f, int k) const {
    return isFar(f) && isFar(k == 0 ? mesh_[f].previous : k == 1 ? mesh_[f].next : f);
  }

  void findFar(const ElementRuns& runs, int largestOuter) {
    for (int r = 0; r < runs.size(); ++r) {
      const ElementRange all = {runs[r].first, runs[r].last};
      const ElementLanes chosen = runs.choose(element_, r, all, largestOuter);
      std::copy_n(chosen.far, all.last - all.first, far_.begin() + all.first);
    }
  }

  void listComponents() {
    for (int f = 0; f < mesh_.size(); ++f)
      for (int j = 0; j < mesh_[f].degree; ++j)
        for (int c = 0; c < 2; ++c) {
          if (!isFar(f))
            components_.push_back({Kind::Density, f, j, c});
          if (!isFar(f) || (j == 0 && !(isFar(f, 0) && isFar(f, 1))))
            components_.push_back({Kind::Slope, f, j, c});
        }
  }

  GradedRule ruleOf(TractionForm form) const {
    std::vector<Feature> features;
    int degree = mesh_[element_].degree;
    double smallest = 1e-16;
    for (const Component& component : components_) {
      if (component.kind == Kind::Density || component.j > 0 || component.c > 0)
        continue;  // each source once
      const Element& source = mesh_[component.element];
      degree = std::max(degree, source.degree);
      smallest = std::min(smallest, 1e-16 * source.half / mesh_[element_].half);
      appendEnds(mesh_, element_, component.element, features);
    }
    degree += moments_;
    return form == TractionForm::Exact ? gradedRule(features, 17 + degree / 2, smallest)
                                       : touchingRule(features, degree, 7);
  }

  /// x and y of the components' values at the points of a rule, times roots of its weights.
  std::array<Matrix, 2> sample(const GradedRule& rule) const {
    const Index points = rule.size();
    const Element& element = mesh_[element_];
    std::vector<TestPoints> tests(at((points + lanes - 1) / lanes));
    for (Index q = 0; q < points; ++q) {
      TestPoints& to = tests[at(q / lanes)];
      to.normal.set(asInt(q % lanes),
                    asComplex(element.curve.normal(rule.points[at(q)].t)));
      to.root.lane[q % lanes] = std::sqrt(rule.weights[at(q)] * element.half);
    }
    const auto count = static_cast<Index>(components_.size());
    std::array<Matrix, 2> samples = {Matrix::unset(points, count),
                                     Matrix::unset(points, count)};
    const Component* const end = components_.data() + components_.size();
    std::vector<ComplexLanes> values;
    for (const Component* from = components_.data(); from != end;) {
      const int f = from->element;
      const Component* to =
          std::find_if(from, end, [f](const Component& of) { return of.element != f; });
      ElementPotential source(mesh_[f].curve, mesh_[f].degree);
      values.resize(static_cast<std::size_t>(to - from));
      const std::vector<TargetLanes> seen = seenFrom(mesh_, f, element_, rule.points);
      for (std::size_t k = 0; k < seen.size(); ++k) {
        source.evaluate(seen[k]);
        dispatch(Sampling{lame_, source, from, to, tests[k], values.data()});
        const Index first = static_cast<Index>(k) * lanes;
        for (const Component* of = from; of != to; ++of) {
          const Index column = of - components_.data();
          const ComplexLanes& value = values[static_cast<std::size_t>(of - from)];
          const Index used = std::min<Index>(lanes, points - first);
          std::copy_n(value.re.lane, used, samples[0].column(column) + first);
          std::copy_n(value.im.lane, used, samples[1].column(column) + first);
        }
      }
      from = to;
    }
    return samples;
  }

  /// P̂_i at the points of a rule, times roots of its weights by arc length.
  Matrix weightedTests(const GradedRule& rule) const {
    const Index points = rule.size();
    Matrix tests(points, moments_);
    std::vector<double> legendre(static_cast<std::size_t>(moments_) + 1);
    for (Index q = 0; q < points; ++q) {
      legendreValues(moments_ - 1, rule.points[at(q)].t, legendre.data());
      for (int i = 0; i < moments_; ++i)
        tests(q, i) = std::sqrt(rule.weights[at(q)] * (i + 0.5)) * legendre[at(i)];
    }
    return tests;
  }

  /// The 1/2 of K' + 1/2.
  void addHalf() {
    for (std::size_t s = 0; s < components_.size(); ++s) {
      const auto& [kind, f, j, c] = components_[s];
      if (f == element_ && kind == Kind::Density && j < moments_)
        near_(2 * j + c, static_cast<Index>(s)) +=
            0.5 * std::sqrt(mesh_[f].half / (j + 0.5));
    }
  }

  // R of samples P = Q R, in the order of the sources, without rows that do not matter
  static Matrix triangularFactor(Matrix samples) {
    const std::vector<Index> places = pivotedTriangle(samples);
    const Index n = samples.columns();
    Index rank = 0;
    const double largest = std::abs(samples(0, 0));
    while (rank < std::min(samples.rows(), n) &&
           std::abs(samples(rank, rank)) > 1e-13 * largest)
      ++rank;
    Matrix factor(rank, n);
    for (Index c = 0; c < n; ++c)
      for (Index r = 0; r < std::min(rank, c + 1); ++r)
        factor(r, places[at(c)]) = samples(r, c);
    return factor;
  }

  void addComponents(const Matrix& values, Index first, TractionRows& out) const {
    for (std::size_t s = 0; s < components_.size(); ++s) {
      const auto& [kind, f, j, c] = components_[s];
      const auto addTo = [&](Index row, double factor) {
        for (Index r = 0; r < values.rows(); ++r)
          out.rows(row, first + r) += factor * values(r, static_cast<Index>(s));
      };
      if (kind == Kind::Density)
        addTo(space_.displacements() + space_.density(f, j, c), 1);
      const auto [firstOf, lastOf] = DisplacementBasis::withDerivative(j);
      for (int k = firstOf; k <= lastOf && kind == Kind::Slope; ++k)
        if (!isFar(f, k))
          addTo(space_.displacement(f, k, c),
                DisplacementBasis::slope(k) / mesh_[f].half);
    }
  }

  const Space& space_;
  const Mesh& mesh_;
  Lame lame_;
  int element_;
  int moments_;
  std::vector<char> far_;
  std::vector<Component> components_;  ///< of near sources, one source after the other
  Matrix near_;                        ///< moments x components
  Matrix beyond_;
};

using Rows = std::vector<std::unique_ptr<const ElementRows>>;

/// Adds what far sources give to the elements first ... last - 1, eight at most.
void addFar(const Rows& rows, std::size_t first, std::size_t last, const Mesh& mesh,
            FarBlocks& blocks, TractionRows& out) {
  std::vector<FarBlocks::Test> tests;
  for (int f = 0; f < mesh.size(); ++f) {
    tests.clear();
    int moments = 0;
    for (std::size_t k = first; k < last; ++k)
      if (rows[k]->isFar(f)) {
        tests.push_back({rows[k]->element(), mesh.offset(rows[k]->element(), f)});
        moments = std::max(moments, rows[k]->moments());
      }
    if (tests.empty())
      continue;
    blocks.evaluateTractions(tests, f, moments);
    int lane = 0;
    for (std::size_t k = first; k < last; ++k)
      if (rows[k]->isFar(f))
        rows[k]->addFar(f, blocks, lane++, out.start[k], out);
  }
}

}  // namespace

TractionRows kernelRows(const Space& space, const Lame& lame,
                        const std::vector<int>& elements, const std::vector<int>& moments,
                        TractionForm form) {
  const Mesh& mesh = space.mesh();
  for (const Element& element : mesh.elements())
    if (element.densities > element.degree)
      throw InputError("tractions of ", element.densities,
                       " functions of a density on an element of degree ", element.degree,
                       "; as many as its degree are possible");
  const ElementRuns runs(mesh);
  const auto count = static_cast<Index>(elements.size());
  constexpr double ofNearSources = 5e4;  // ns
  constexpr double ofFarSource = 100;
  Rows rows(elements.size());
  const auto targets = static_cast<double>(count);
  parallelFor({count, ofNearSources * targets}, [&](Index k) {
    rows[at(k)] = std::make_unique<const ElementRows>(space, lame, runs, elements[at(k)],
                                                      moments[at(k)], form);
  });
  TractionRows out;
  out.start.assign(1, 0);
  for (const auto& of : rows)
    out.start.push_back(out.start.back() + of->columns());
  out.rows = Matrix(space.displacements() + space.densities(), out.start.back());
  const std::shared_ptr<const Kernel> kernel = elasticKernel(mesh.outline(), lame);
  parallelFor(
      {(count + lanes - 1) / lanes, ofFarSource * targets * mesh.size()},
      [&] { return kernel->far(space); },
      [&](std::unique_ptr<FarBlocks>& blocks, Index group) {
        const std::size_t first = at(group * lanes);
        const std::size_t last = std::min(first + lanes, rows.size());
        addFar(rows, first, last, mesh, *blocks, out);
        for (std::size_t k = first; k < last; ++k)
          rows[k]->addNear(out.start[k], out);
      });
  return out;
}

std::shared_ptr<const TractionRows> tractionRows(const Space& space, const Lame& lame,
                                                 const SteklovPoincare& stiffness,
                                                 const std::vector<int>& elements,
                                                 TractionForm form) {
  std::vector<int> moments;
  moments.reserve(elements.size());
  for (const int e : elements)
    moments.push_back(space.mesh()[e].degree + 1);
  TractionRows tractions = kernelRows(space, lame, elements, moments, form);
  const Index displacements = space.displacements();
  const Matrix& all = tractions.rows;
  tractions.rows =
      stiffness.addAdjointDensity(rowsBetween(all, 0, displacements).copy(),
                                  rowsBetween(all, displacements, all.rows()).copy());
  return std::make_shared<const TractionRows>(std::move(tractions));
}

}  // namespace epafi::bem
