#include "bem/operators/FarBlocks.hpp"

#include "bem/basis/Legendre.hpp"
#include "bem/operators/LocalFunctions.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace epafi::bem {

namespace {

using Work = FarBlocks::Work;

/// Tractions: without V and K; Fields: these alone.
enum class Rows { All, Tractions, Fields };

template <class Points>
struct Sizes {
  static constexpr int v = sizeof(Points::v) / sizeof(Pack);
  static constexpr int k = sizeof(Points::k) / sizeof(Pack);
  static constexpr int t = sizeof(Points::t) / sizeof(Pack);
  static constexpr int w = sizeof(Points::w) / sizeof(Pack);
  static constexpr int ofNode = k + w;
  static constexpr int ofDensity = v + t;
};

/// Sums over the inner points for each function of the trial element.
template <class Number, class Size>
struct Inner {
  Number* v;  ///< of densities
  Number* k;  ///< of displacements
  Number* t;
  Number* w;

  EPAFI_INLINE Inner(Number* sums, int nodes, int densities)
      : v(sums),
        k(v + Size::v * densities),
        t(k + Size::k * nodes),
        w(t + Size::t * densities) {}
};

}  // namespace

template <class Points>
struct FarQuadrature<Points>::Integrate {
  using Size = Sizes<Points>;
  static constexpr int n = Points::components;

  const typename Points::Constants& constants;
  const Work& work;
  const AlignedLane* outer;
  const double* outerValues;
  const double* halves;
  const double* inner;
  const double* innerValues;
  AlignedLane* sums;
  AlignedLane* block;

  template <Division How>
  EPAFI_INLINE void run() const {
    const bool isLinear = work.columnDegree == 1 && work.columnDensities == 1;
    if (work.rowNodes == 0)
      isLinear ? fields<How, 1>() : fields<How, 0>();
    else if (work.rowDensities == 0)
      isLinear ? integrate<How, 1, Rows::Tractions>()
               : integrate<How, 0, Rows::Tractions>();
    else if (isLinear && work.rowNodes == 2 && work.rowDensities == 1)
      integrate<How, 1, Rows::All>();
    else
      integrate<How, 0, Rows::All>();
  }

  /// Degree: of the trial element, and of the tests where all rows are wanted; 0: any.
  template <Division How, int Degree, Rows Wanted>
  EPAFI_INLINE void integrate() const {
    constexpr bool isFixed = Degree > 0 && Wanted == Rows::All;
    const int rowNodes = isFixed ? Degree + 1 : work.rowNodes;
    const int rowDensities = isFixed               ? Degree
                             : Wanted == Rows::All ? work.rowDensities
                                                   : 0;
    const int nodes = (Degree > 0 ? Degree : work.columnDegree) + 1;
    const int densities = Degree > 0 ? Degree : work.columnDensities;
    const int columns = n * (nodes + densities);
    const int count = n * (rowNodes + rowDensities) * columns;
    for (int i = 0; i < count; ++i)
      store(block[i].lane, Pack{});
    for (int p = 0; p < work.outer; ++p) {
      sumInner<How, Degree, Wanted>(p, nodes, densities);
      const Inner<AlignedLane, Size> in(sums, nodes, densities);
      const double* values = outerValues + p * (rowNodes + rowDensities);
      for (int i = 0; i < rowNodes; ++i) {
        const Pack phi = values[i] * load(halves);
        AlignedLane* row = block + n * i * columns;
        for (int j = 0; j < nodes; ++j)
          addBlock<Size::w>(phi, in.w + Size::w * j, row + n * j, columns);
        for (int j = 0; j < densities; ++j)
          addBlock<Size::t>(phi, in.t + Size::t * j, row + n * (nodes + j), columns);
      }
      for (int i = 0; i < rowDensities; ++i) {
        const Pack chi = values[rowNodes + i] * load(halves);
        AlignedLane* row = block + n * (rowNodes + i) * columns;
        for (int j = 0; j < nodes; ++j)
          addBlock<Size::k>(chi, in.k + Size::k * j, row + n * j, columns);
        for (int j = 0; j < densities; ++j)
          addBlock<Size::v>(chi, in.v + Size::v * j, row + n * (nodes + j), columns);
      }
    }
  }

  /// V and K at each of the outer points.
  template <Division How, int Degree>
  EPAFI_INLINE void fields() const {
    const int width = Size::v * work.columnDensities + Size::k * (work.columnDegree + 1);
    for (int p = 0; p < work.outer; ++p) {
      sumInner<How, Degree, Rows::Fields>(p, work.columnDegree + 1, work.columnDensities);
      std::copy_n(sums, width, block + p * width);
    }
  }

  /// Entries of a function at its rows and columns.
  template <int Entries>
  EPAFI_INLINE static void addBlock(const Pack& factor, const AlignedLane* from,
                                    AlignedLane* to, int columns) {
    add(to[0].lane, factor * load(from[0].lane));
    if constexpr (Entries == 3) {
      const Pack xy = factor * load(from[1].lane);
      add(to[columns].lane, xy);
      add(to[1].lane, xy);
      add(to[columns + 1].lane, factor * load(from[2].lane));
    } else if constexpr (Entries == 4) {
      add(to[columns].lane, factor * load(from[1].lane));
      add(to[1].lane, factor * load(from[2].lane));
      add(to[columns + 1].lane, factor * load(from[3].lane));
    }
  }

  /// Degree: of the trial element, whose sums then stay in registers; 0: any.
  template <Division How, int Degree, Rows Wanted>
  // NOLINTNEXTLINE(readability-function-cognitive-complexity): loops that add
  EPAFI_INLINE void sumInner(int p, int anyNodes, int anyDensities) const {
    const int nodes = Degree > 0 ? Degree + 1 : anyNodes;
    const int densities = Degree > 0 ? Degree : anyDensities;
    const int size = Size::ofNode * nodes + Size::ofDensity * densities;
    Pack own[Degree > 0 ? Size::ofNode * (Degree + 1) + Size::ofDensity * Degree : 1];
    Pack* const to = Degree > 0 ? own : reinterpret_cast<Pack*>(sums);
    for (int i = 0; i < size; ++i)
      to[i] = Pack{};
    const Inner<Pack, Size> in(to, nodes, densities);
    const AlignedLane* const target = outer + outerSize * p;
    const Pack x = load(target[0].lane);
    const Pack y = load(target[1].lane);
    const Pack tx = load(target[2].lane);
    const Pack ty = load(target[3].lane);
    const Pack radius = load(target[4].lane);
    for (int q = 0; q < work.inner; ++q) {
      const double* s = inner + innerSize * q;
      const double* values = innerValues + (nodes + densities) * q;
      Points g;  // NOLINT(cppcoreguidelines-pro-type-member-init)
      g.template evaluate<How>(constants, x - s[0], y - s[1], tx, ty, radius, s);
      for (int j = 0; j < nodes; ++j) {
        for (int i = 0; i < Size::w && Wanted != Rows::Fields; ++i)
          in.w[Size::w * j + i] += values[j] * g.w[i];
        for (int i = 0; i < Size::k && Wanted != Rows::Tractions; ++i)
          in.k[Size::k * j + i] += values[j] * g.k[i];
      }
      for (int j = 0; j < densities; ++j) {
        for (int i = 0; i < Size::v && Wanted != Rows::Tractions; ++i)
          in.v[Size::v * j + i] += values[nodes + j] * g.v[i];
        for (int i = 0; i < Size::t && Wanted != Rows::Fields; ++i)
          in.t[Size::t * j + i] += values[nodes + j] * g.t[i];
      }
    }
    for (int i = 0; i < size && Degree > 0; ++i)
      store(sums[i].lane, own[i]);
  }
};

namespace {

/// Gauss points of the test elements, and tangents.
struct Sampling {
  const ElementLanes& tests;
  const AlignedLane& radii;  ///< of their middles
  const Rule& rule;
  AlignedLane* to;
  int size;  ///< of a point

  template <Division>
  EPAFI_INLINE void run() const {
    AlignedLane* point = to;
    for (int p = 0; p < rule.size(); ++p, point += size) {
      const ElementLanes::Points x = tests.at(Pack{} + rule.points[at(p)]);
      store(point[0].lane, load(tests.wx) + x.place.re);
      store(point[1].lane, load(tests.wy) + x.place.im);
      store(point[2].lane, x.tangent.re);
      store(point[3].lane, x.tangent.im);
      store(point[4].lane, load(radii.lane) + x.place.re);
    }
  }
};

}  // namespace

Nearness FarBlocks::orderOf(const std::vector<Test>& tests, int trial) const {
  Nearness largest{1, 1};
  for (const Test& test : tests)  // of a near one zero: the caller does not take it
    largest.include(nearness(space_.mesh(), test.element, trial, test.offset));
  return largest;
}

const std::vector<double>& FarBlocks::functions(int points, int degree, int densities) {
  std::vector<double>& values = functions_[{points, degree, densities}];
  if (values.empty())
    values = weightedFunctions(gaussLegendre(points), degree, densities, 1);
  return values;
}

void FarBlocks::sampleTests(const std::vector<Test>& tests) {
  const Rule& rule = gaussLegendre(work_.outer);
  outer_.resize(outerSize * work_.outer);
  AlignedLane radii;
  for (int lane = 0; lane < lanes; ++lane) {
    const Test& test = tests[std::min(at(lane), tests.size() - 1)];
    const Element& element = space_.mesh()[test.element];
    tests_.set(lane, test.offset, element);
    radii.lane[lane] = element.curve.frame().middle.x;
  }
  dispatch(Sampling{tests_, radii, rule, outer_.data(), outerSize});
}

void FarBlocks::sampleTrial(const Element& element) {
  if (sampled_ == &element && static_cast<int>(inner_.size()) == innerSize * work_.inner)
    return;
  sampled_ = &element;
  const Rule& rule = gaussLegendre(work_.inner);
  inner_.resize(innerSize * work_.inner);
  for (std::size_t q = 0; q < rule.points.size(); ++q) {
    const Vec2 y = element.curve.fromMiddle(rule.points[q]);
    const Vec2 tangent = element.curve.tangent(rule.points[q]);
    double* to = inner_.data() + innerSize * q;
    to[0] = y.x;
    to[1] = y.y;
    to[2] = tangent.x;
    to[3] = tangent.y;
    to[4] = element.curve.frame().middle.x + y.x;
  }
  innerValues_ = functions(work_.inner, element.degree, element.densities);
  for (double& value : innerValues_)
    value *= element.half;
}

void FarBlocks::evaluate(const std::vector<Test>& tests, int trial) {
  Functions rows;
  for (const Test& test : tests) {
    const Element& row = space_.mesh()[test.element];
    rows.degree = std::max(rows.degree, row.degree);
    rows.densities = std::max(rows.densities, row.densities);
  }
  work_.rowNodes = rows.degree + 1;
  work_.rowDensities = rows.densities;
  integrate(tests, rows, trial);
}

void FarBlocks::evaluateTractions(const std::vector<Test>& tests, int trial,
                                  int moments) {
  work_.rowNodes = moments;
  work_.rowDensities = 0;
  integrate(tests, {-1, moments}, trial);
}

void FarBlocks::evaluateFields(const std::vector<AlignedLane>& points, int trial,
                               int order) {
  work_.rowNodes = work_.rowDensities = 0;
  work_.outer = static_cast<int>(points.size()) / 2;
  outer_.assign(outerSize * work_.outer, {});
  const Element& element = space_.mesh()[trial];
  for (int p = 0; p < work_.outer; ++p) {
    AlignedLane* to = outer_.data() + outerSize * p;
    std::copy_n(points.data() + 2 * p, 2, to);
    for (int lane = 0; lane < lanes; ++lane)
      to[4].lane[lane] = element.curve.frame().middle.x + to[0].lane[lane];
  }
  columns_ = entries_.v * element.densities + entries_.k * (element.degree + 1);
  block_.resize(work_.outer * columns_);
  run(element, order);
}

void FarBlocks::integrate(const std::vector<Test>& tests, const Functions& rows,
                          int trial) {
  const Element& element = space_.mesh()[trial];
  const Nearness order = orderOf(tests, trial);
  // P_i themselves are larger at an element's ends than φ_k are
  const int atEnds = rows.degree < 0 ? 2 : 0;
  work_.outer = gaussPoints(order.outer, rows.degree, rows.densities + atEnds);
  sampleTests(tests);
  outerValues_ = functions(work_.outer, rows.degree, rows.densities).data();
  columns_ = entries_.components * (element.degree + 1 + element.densities);
  block_.resize(entries_.components * (work_.rowNodes + work_.rowDensities) * columns_);
  run(element, order.inner);
}

void FarBlocks::run(const Element& trial, int order) {
  work_.columnDegree = trial.degree;
  work_.columnDensities = trial.densities;
  work_.inner = gaussPoints(order, trial.degree, trial.densities);
  sampleTrial(trial);
  sums_.resize((entries_.k + entries_.w) * (trial.degree + 1) +
               (entries_.v + entries_.t) * trial.densities);
  compute();
}

template <class Points>
FarQuadrature<Points>::FarQuadrature(const Space& space,
                                     const typename Points::Constants& constants)
    : FarBlocks(space, {Points::components, Sizes<Points>::v, Sizes<Points>::k,
                        Sizes<Points>::t, Sizes<Points>::w}),
      constants_(constants) {
  assert(space.components() == Points::components);
}

template <class Points>
void FarQuadrature<Points>::compute() {
  dispatch(Integrate{constants_, work_, outer_.data(), outerValues_, tests_.half,
                     inner_.data(), innerValues_.data(), sums_.data(), block_.data()});
}

template class FarQuadrature<KelvinPoints>;
template class FarQuadrature<LaplacePoints>;
template class FarQuadrature<RingPoints>;

}  // namespace epafi::bem
