#include "bem/moments/NearPairs.hpp"

#include "bem/moments/ElementPotential.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>
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

/// Integrals with some P_i P_j, over the points in each lane.
struct LaneSums {
  AlignedLane log;
  ComplexLanes phase;
  AlignedLane direct;
  AlignedLane reverse;
};

/// Integrates the potential of y over x.
struct Integration {
  const Element& x;
  const GradedRule& rule;
  const SeenPoints& points;
  ElementPotential& potential;
  InstructionSet set;
  int rows;
  int columns;
  bool onLine;  ///< only log is asked for
  LaneSums* sums;

  template <Division>
  EPAFI_INLINE void run() const {
    for (int k = 0; k < (rows + 1) * (columns + 1); ++k)
      sums[k] = LaneSums{};
    Pack weighted[largestMoment + 1];
    for (std::size_t k = 0; k < points.size(); ++k) {
      potential.evaluate(points, k, set);
      AlignedLane places{};
      AlignedLane weights{};
      ComplexLanes normals{};
      for (std::size_t q = k * lanes; q < std::min((k + 1) * lanes, rule.points.size());
           ++q) {
        places.lane[q % lanes] = rule.points[q].t;
        weights.lane[q % lanes] = rule.weights[q];
        normals.set(static_cast<int>(q % lanes),
                    x.half * asComplex(x.curve.normal(rule.points[q].t)));
      }
      const Pack t = load(places.lane);
      weighted[0] = load(weights.lane);
      weighted[1] = t * weighted[0];
      for (int i = 1; i < rows; ++i)
        weighted[i + 1] = ((2 * i + 1.0) / (i + 1)) * (t * weighted[i]) -
                          (i / (i + 1.0)) * weighted[i - 1];
      const ComplexPack normal = normals.load();
      for (int j = 0; j <= columns; ++j)
        add(potential.of(j), normal, weighted, j);
    }
  }

  EPAFI_INLINE void add(const ElementPotential::Values& of, const ComplexPack& normal,
                        const Pack* weighted, int j) const {
    LaneSums* const to = sums + j * (rows + 1);
    for (int i = 0; i < rows && j < columns; ++i)
      bem::add(to[i].log.lane, weighted[i] * of.log);
    if (onLine)
      return;
    for (int i = 0; i < rows; ++i)
      bem::add(to[i].direct.lane, weighted[i] * of.flow);
    if (j == columns)
      return;
    for (int i = 0; i < rows; ++i) {
      bem::add(to[i].phase.re.lane, weighted[i] * of.phase.re);
      bem::add(to[i].phase.im.lane, weighted[i] * of.phase.im);
    }
    const Pack reverse = -(normal.re * of.overConj.re + normal.im * of.overConj.im);
    for (int i = 0; i <= rows; ++i)
      bem::add(to[i].reverse.lane, weighted[i] * reverse);
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
  for (int i = 0; i <= x.densities; ++i)
    for (int j = 0; j <= x.densities; ++j) {
      const int at = i * TileMoments::stride + j;
      m.log[at][lane] = selfMoment(i, j);
      m.along[at][lane] = m.across[at][lane] = 0;
      m.direct[at][lane] = m.reverse[at][lane] = 0;
    }
  m.log[0][lane] += 4 * std::log(x.half);
}

void nearMoments(const Mesh& mesh, int e, int f, const GradedRule& rule, TileMoments& m,
                 int lane, InstructionSet set) {
  const InOrder pair(mesh, e, f);
  const Element& x = mesh[pair.x];
  const Element& y = mesh[pair.y];
  const int rows = x.densities;
  const int columns = y.densities;
  const bool onLine = mesh.areOnLine(e, f);  // w·n = 0
  using Need = ElementPotential::Need;
  ElementPotential potential(y.curve, columns + (onLine ? 0 : 1),
                             onLine ? Need::Log : Need::Moments);
  LaneSums sums[(largestMoment + 1) * (largestMoment + 1)];
  const SeenPoints points(mesh, pair.y, pair.x, rule.points);
  dispatch(set,
           Integration{x, rule, points, potential, set, rows, columns, onLine, sums});
  const Complex tangent = asComplex(mesh[f].curve.frame().tangent);
  const double scale = 1 / y.half;
  const Complex back = scale * std::conj(tangent * tangent);
  m.setPair(rows, columns, pair.transposed, lane, [&](int i, int j) {
    const LaneSums& of = sums[j * (rows + 1) + i];
    const double log = scale * total(of.log);
    if (onLine)
      return PairSums{log, i == 0 && j == 0 ? 4.0 : 0.0, 0, 0};
    const Complex phase(total(of.phase.re), total(of.phase.im));
    return PairSums{log, back * phase, total(of.direct), scale * total(of.reverse)};
  });
}

}  // namespace epafi::bem
