#include "bem/moments/NearPairs.hpp"

#include "bem/moments/ElementPotential.hpp"
#include "bem/simd/Dispatch.hpp"

#include <cmath>

namespace epafi::bem {

namespace {

// ∫ P_n Q_m dt over [-1,1] for n + m odd, principal value.            [DLMF 14.17.9]
double integralPQ(int n, int m) { return 2.0 / ((n - m) * (n + m + 1.0)); }

// A segment with itself:  log|w| = log(h/2) + log|s-t|,  w/conj(w) = τ²,  w·n = 0.
double selfMoment(int i, int j) {
  if ((i + j) % 2 == 1)
    return 0;
  if (j == 0)
    return i == 0 ? 4 * std::log(2.0) - 6
                  : 2 * (integralPQ(0, i + 1) - integralPQ(0, i - 1)) / (2 * i + 1);
  return 2 * (integralPQ(i, j + 1) - integralPQ(i, j - 1)) / (2 * j + 1);
}

/// Elements of a pair, x the smaller one: the potential of the larger one is smoother on it.
struct InOrder {
  bool transposed;
  int x;
  int y;
  InOrder(const Mesh& mesh, int e, int f)
      : transposed(mesh[e].half > mesh[f].half),
        x(transposed ? f : e),
        y(transposed ? e : f) {}
};

/// 1e-13 of the moments' norm with polynomials of both degrees: where the elements touch,
/// integrands are like log s in the distance s, on one edge like s log s.
GradedRule nearRule(const Mesh& mesh, const InOrder& pair) {
  std::vector<Feature> features;
  appendEnds(mesh, pair.x, pair.y, features);
  const Element& x = mesh[pair.x];
  const Element& y = mesh[pair.y];
  const bool hasArc = mesh.lineOf(pair.x) < 0 || mesh.lineOf(pair.y) < 0;
  return touchingRule(features, x.densities + y.densities + (hasArc ? 6 : 0),
                      x.piece.edge == y.piece.edge ? 5 : 7);
}

/// Eight points of x: weighted P_0 there, and the normal times its half length.
struct TestPoints {
  AlignedLane place{};
  AlignedLane weight{};
  ComplexLanes normal{};
};

/// Integrals with some P_i P_j, over the points in each lane.
struct LaneSums {
  AlignedLane log{};
  ComplexLanes phase{};
  AlignedLane direct{};
  AlignedLane reverse{};
};

/// Adds eight points.
struct Addition {
  const ElementPotential& potential;
  const TestPoints& points;
  int rows;
  int columns;
  bool onLine;  ///< only log is asked for
  LaneSums* sums;

  template <Division>
  EPAFI_INLINE void run() const {
    Pack weighted[largestMoment + 1];
    const Pack t = load(points.place.lane);
    weighted[0] = load(points.weight.lane);
    weighted[1] = t * weighted[0];
    for (int k = 1; k < rows; ++k)
      weighted[k + 1] = ((2 * k + 1.0) / (k + 1)) * (t * weighted[k]) -
                        (k / (k + 1.0)) * weighted[k - 1];
    const ComplexPack normal = points.normal.load();
    for (int j = 0; j <= columns; ++j) {
      const ElementPotential::Values of = potential.of(j);
      const Pack reverse = -(normal.re * of.overConj.re + normal.im * of.overConj.im);
      for (int i = 0; i <= rows; ++i) {
        LaneSums& to = sums[i * (columns + 1) + j];
        add(to.log.lane, weighted[i] * of.log);
        if (onLine)
          continue;
        add(to.phase.re.lane, weighted[i] * of.phase.re);
        add(to.phase.im.lane, weighted[i] * of.phase.im);
        add(to.direct.lane, weighted[i] * of.flow);
        add(to.reverse.lane, weighted[i] * reverse);
      }
    }
  }
};

double total(const AlignedLane& sums) {
  const double* x = sums.lane;
  return ((x[0] + x[1]) + (x[2] + x[3])) + ((x[4] + x[5]) + (x[6] + x[7]));
}

}  // namespace

void nearMoments(const Mesh& mesh, int e, int f, TileMoments& m, int lane,
                 InstructionSet set) {
  const InOrder pair(mesh, e, f);
  if (e != f || mesh.lineOf(e) < 0)
    return nearMoments(mesh, e, f, nearRule(mesh, pair), m, lane, set);
  const Element& x = mesh[e];
  m.setPair(x.densities, x.densities, false, lane, [&](int i, int j) {
    const double whole = i == 0 && j == 0 ? 4 : 0;
    return PairSums{selfMoment(i, j) + whole * std::log(x.half), whole, 0, 0};
  });
}

void nearMoments(const Mesh& mesh, int e, int f, const GradedRule& rule, TileMoments& m,
                 int lane, InstructionSet set) {
  const InOrder pair(mesh, e, f);
  const Element& x = mesh[pair.x];
  const Element& y = mesh[pair.y];
  const int rows = x.densities;
  const int columns = y.densities;
  ElementPotential potential(y.curve, columns + 1, ElementPotential::Need::Moments);
  std::vector<LaneSums> sums(static_cast<std::size_t>((rows + 1) * (columns + 1)));
  const bool onLine = mesh.areOnLine(e, f);  // w·n = 0
  std::size_t q = 0;
  for (const TargetLanes& seen : seenFrom(mesh, pair.y, pair.x, rule.points)) {
    TestPoints points;
    for (int k = 0; k < lanes && q < rule.points.size(); ++k, ++q) {
      points.place.lane[k] = rule.points[q].t;
      points.weight.lane[k] = rule.weights[q];
      points.normal.set(k, x.half * asComplex(x.curve.normal(rule.points[q].t)));
    }
    potential.evaluate(seen, set);
    dispatch(set, Addition{potential, points, rows, columns, onLine, sums.data()});
  }
  const Complex tangent = asComplex(mesh[f].curve.frame().tangent);
  const Complex back = std::conj(tangent * tangent);
  m.setPair(rows, columns, pair.transposed, lane, [&](int i, int j) {
    const LaneSums& of = sums[static_cast<std::size_t>(i * (columns + 1) + j)];
    const double log = total(of.log) / y.half;
    if (onLine)
      return PairSums{log, i == 0 && j == 0 ? 4.0 : 0.0, 0, 0};
    const Complex phase(total(of.phase.re), total(of.phase.im));
    return PairSums{log, back * phase / y.half, total(of.direct),
                    total(of.reverse) / y.half};
  });
}

}  // namespace epafi::bem
