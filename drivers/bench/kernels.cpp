// What one thread takes for the kernels of packages/bem, by Google Benchmark: nanoseconds
// per pair of elements, per point and element, and seconds per operation of the dense
// algebra.
//
//   build/bin/bench_kernels [--benchmark_filter=REGEX] [--benchmark_repetitions=5]
#include "bem/fields/BoundaryFields.hpp"
#include "bem/fields/Interior.hpp"
#include "bem/moments/FarPairs.hpp"
#include "bem/moments/NearPairs.hpp"
#include "bem/operators/Assembly.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "bem/tractions/TractionRows.hpp"

#include <benchmark/benchmark.h>
#include <cmath>
#include <memory>
#include <random>
#include <string>

namespace epafi::bem {

namespace {

const Lame lame({100, 0.3, true});

std::shared_ptr<const Outline> square() {
  return std::make_shared<const Outline>(
      Loop{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {"contact", "right", "top", "left"}});
}

Mesh uniform(int elements, int degree) {
  return makeMesh(square(), std::vector<int>(4, elements / 4), degree);
}

/// Elements graded by 0.15 toward every corner, degrees growing by 1 from there: what
/// "Graded hp" ends with.
Mesh graded(int layers, int largest) {
  const std::shared_ptr<const Outline> outline = square();
  std::vector<Piece> pieces;
  for (int edge = 0; edge < 4; ++edge) {
    const double length = outline->edge(edge).curve.length();
    std::vector<Position> nodes;
    const auto node = [&](double fromStart, double toEnd) {
      nodes.push_back({length * fromStart, length * toEnd});
    };
    node(0, 1);
    for (int k = layers; k >= 1; --k)
      node(0.5 * std::pow(0.6, k), 1 - 0.5 * std::pow(0.6, k));
    node(0.5, 0.5);
    for (int k = 1; k <= layers; ++k)
      node(1 - 0.5 * std::pow(0.6, k), 0.5 * std::pow(0.6, k));
    node(1, 0);
    const int count = static_cast<int>(nodes.size()) - 1;
    for (int k = 0; k < count; ++k)
      pieces.push_back({edge, nodes[k], nodes[static_cast<std::size_t>(k) + 1],
                        std::min(largest, 1 + std::min(k, count - 1 - k) / 4)});
  }
  return Mesh(outline, pieces);
}

ElementLanes farLanes(int degree, int order) {
  ElementLanes far{};
  far.densities = degree;
  far.smooth = {order - degreeShare(degree), order - degreeShare(degree)};
  for (int lane = 0; lane < lanes; ++lane) {
    far.wx[lane] = 2 + 0.25 * lane;
    far.wy[lane] = 1 + 0.125 * lane;
    far.tx[lane] = std::cos(0.3 * lane);
    far.ty[lane] = std::sin(0.3 * lane);
    far.half[lane] = 0.1;
  }
  return far;
}

void perItem(benchmark::State& state, const char* name, double items) {
  state.counters[name] = benchmark::Counter(
      items, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// range: degree, Gauss points in each direction.
void farPair(benchmark::State& state) {
  const int degree = static_cast<int>(state.range(0));
  const int order = static_cast<int>(state.range(1));
  const Mesh mesh = uniform(4, degree);
  const ElementLanes far = farLanes(degree, order);
  const auto moments = std::make_unique<Tile>();
  for (auto _ : state) {
    farMoments(mesh[0], far, *moments);
    benchmark::DoNotOptimize(moments->log[0][0]);
  }
  perItem(state, "seconds_per_pair", lanes);
}
BENCHMARK(farPair)->Args({1, 4})->Args({1, 8})->Args({2, 6})->Args({4, 8})->Args({8, 12});

void nearMomentsOf(benchmark::State& state, const Mesh& mesh, int e, int f) {
  const auto moments = std::make_unique<Tile>();
  for (auto _ : state) {
    nearMoments(mesh, e, f, *moments, 0);
    benchmark::DoNotOptimize(moments->log[0][0]);
  }
  perItem(state, "seconds_per_pair", 1);
}

/// range: degree, distance of the two elements' numbers (0 self, 1 neighbours, 2 next).
void nearPair(benchmark::State& state) {
  const Mesh mesh = uniform(64, static_cast<int>(state.range(0)));
  nearMomentsOf(state, mesh, 4 + static_cast<int>(state.range(1)), 4);
}
BENCHMARK(nearPair)->ArgsProduct({{1, 2, 4, 8}, {0, 1}})->Args({1, 16});

/// Elements e and f of a bar with a round end: 0 to 7 below, 8 to 11 round it, 12 to 19 above, 20
/// at the left end.  range: degree.
void nearPairOfBar(benchmark::State& state, int e, int f) {
  Loop bar{{{-1, 0}, {1, 0}, {1, 0.1}, {-1, 0.1}}, {"below", "round", "above", "left"}};
  bar.bulges = {0, 1, 0, 0};
  const Mesh mesh = makeMesh(std::make_shared<const Outline>(bar), {8, 4, 8, 1},
                             static_cast<int>(state.range(0)));
  nearMomentsOf(state, mesh, e, f);
}
BENCHMARK_CAPTURE(nearPairOfBar, corner, 0, 20)->Arg(1)->Arg(2)->Arg(4)->Arg(8);
BENCHMARK_CAPTURE(nearPairOfBar, facing, 3, 16)->Arg(1)->Arg(2)->Arg(4)->Arg(8);
BENCHMARK_CAPTURE(nearPairOfBar, arcItself, 9, 9)->Arg(1)->Arg(2)->Arg(4)->Arg(8);
BENCHMARK_CAPTURE(nearPairOfBar, arcs, 9, 10)->Arg(1)->Arg(2)->Arg(4)->Arg(8);
BENCHMARK_CAPTURE(nearPairOfBar, segmentAndArc, 7, 8)->Arg(1)->Arg(2)->Arg(4)->Arg(8);
BENCHMARK_CAPTURE(nearPairOfBar, segmentBesideArc, 7, 9)->Arg(1)->Arg(2)->Arg(4)->Arg(8);

void assembleOn(benchmark::State& state, const Mesh& mesh) {
  const Space space(mesh);
  for (auto _ : state)
    benchmark::DoNotOptimize(assembleOperators(space, lame).singleLayer.data());
  perItem(state, "seconds_per_ordered_pair",
          static_cast<double>(mesh.size()) * mesh.size());
}

/// V, K and W; range: elements, degree.
void assembly(benchmark::State& state) {
  assembleOn(state,
             uniform(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
}
BENCHMARK(assembly)
    ->Args({256, 1})
    ->Args({1024, 1})
    ->Args({256, 2})
    ->Args({256, 4})
    ->Args({128, 8})
    ->Unit(benchmark::kMillisecond);

void assemblyGraded(benchmark::State& state) {
  const Mesh mesh = graded(37, 8);
  assembleOn(state, mesh);
  double degrees = 0;
  for (const Element& element : mesh.elements())
    degrees += element.degree;
  state.SetLabel(std::to_string(mesh.size()) + " elements, mean degree " +
                 std::to_string(degrees / mesh.size()));
}
BENCHMARK(assemblyGraded)->Unit(benchmark::kMillisecond);

/// S from V, K and W; range: elements, degree.
void steklovPoincare(benchmark::State& state) {
  const Space space(
      uniform(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
  for (auto _ : state) {
    state.PauseTiming();
    Operators operators = assembleOperators(space, lame);
    state.ResumeTiming();
    const SteklovPoincare s(std::move(operators));
    benchmark::DoNotOptimize(s.stiffness().column(0));
  }
}
BENCHMARK(steklovPoincare)->Args({1024, 1})->Unit(benchmark::kMillisecond);

/// The projected tractions on one side of the square; range: elements, degree.
void projectedTractions(benchmark::State& state) {
  const Space space(
      uniform(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
  const std::vector<int> contact = space.mesh().elementsOf("contact");
  const SteklovPoincare s(assembleOperators(space, lame));
  for (auto _ : state)
    benchmark::DoNotOptimize(
        tractionRows(space, lame, s, contact, TractionForm::Projected)->rows.data());
}
BENCHMARK(projectedTractions)
    ->Args({256, 1})
    ->Args({1024, 1})
    ->Args({256, 4})
    ->Unit(benchmark::kMillisecond);

/// Displacement and stress at points inside; range: elements, degree.
void interior(benchmark::State& state) {
  const Space space(
      uniform(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
  const Interior inside(space, lame, Vector(at(space.displacements()), 1),
                        Vector(at(space.densities()), 1));
  const std::vector<Vec2> points(64, {0.1, 0.2});
  for (auto _ : state)
    benchmark::DoNotOptimize(inside.at(points).data());
  perItem(state, "seconds_per_point_and_element",
          static_cast<double>(points.size()) * space.mesh().size());
}
BENCHMARK(interior)->Args({64, 1})->Args({64, 2})->Args({64, 4})->Args({64, 8});

void boundaryFieldsOf(benchmark::State& state, std::size_t count) {
  const Space space(
      uniform(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> between(-1, 1);
  Vector u(space.displacements());
  Vector psi(space.densities());
  for (double& value : u)
    value = between(random);
  for (double& value : psi)
    value = between(random);
  for (auto _ : state) {
    const BoundaryFields fields(space, lame, std::vector<BoundaryState>(count, {u, psi}));
    for (int e = 0; e < space.mesh().size(); ++e)
      benchmark::DoNotOptimize(fields.on(e).data());
  }
  perItem(state, "seconds_per_ordered_pair",
          static_cast<double>(space.mesh().size()) * space.mesh().size());
}

/// The estimator's fields on all elements; range: elements, degree.
void boundaryFields(benchmark::State& state) { boundaryFieldsOf(state, 1); }
BENCHMARK(boundaryFields)
    ->Args({256, 1})
    ->Args({1024, 1})
    ->Args({256, 4})
    ->Unit(benchmark::kMillisecond);

void boundaryFieldsOfEight(benchmark::State& state) { boundaryFieldsOf(state, 8); }
BENCHMARK(boundaryFieldsOfEight)->Args({1024, 1})->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace epafi::bem

BENCHMARK_MAIN();
