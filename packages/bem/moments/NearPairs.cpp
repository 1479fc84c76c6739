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

/// Integrates the potential of y over x; a lane of the sums has what its points give.
struct Integration {
  const Element& x;
  const Element& y;
  const GradedRule& rule;
  const std::vector<TargetLanes>& targets;
  ElementPotential& potential;
  bool onLine;  ///< only log is asked for
  Tile& sums;

  template <Division>
  EPAFI_INLINE void run() const {
    const int rows = x.densities;
    const int columns = y.densities;
    sums.clear(rows, columns);
    Pack weighted[largestMoment + 1];
    for (std::size_t k = 0; k < targets.size(); ++k) {
      potential.evaluate(targets[k]);
      AlignedLane places{};
      AlignedLane weights{};
      ComplexLanes normals{};
      for (std::size_t q = k * lanes; q < std::min((k + 1) * lanes, rule.points.size());
           ++q) {
        places.lane[q % lanes] = rule.points[q].t;
        weights.lane[q % lanes] = rule.weights[q];
        normals.set(static_cast<int>(q % lanes),
                    x.half / y.half * asComplex(x.curve.normal(rule.points[q].t)));
      }
      const Pack t = load(places.lane);
      weighted[0] = load(weights.lane);
      weighted[1] = t * weighted[0];
      for (int i = 1; i < rows; ++i)
        weighted[i + 1] = ((2 * i + 1.0) / (i + 1)) * (t * weighted[i]) -
                          (i / (i + 1.0)) * weighted[i - 1];
      if (onLine)
        addLogs(weighted);
      else
        addAll(normals.load(), weighted);
    }
  }

 private:
  EPAFI_INLINE void addLogs(const Pack* weighted) const {
    for (int j = 0; j < y.densities; ++j) {
      const Pack log = (1 / y.half) * potential.of(j).log;
      for (int i = 0; i < x.densities; ++i)
        add(sums.log[i * Tile::stride + j], weighted[i] * log);
    }
  }

  EPAFI_INLINE void addAll(const ComplexPack& normal, const Pack* weighted) const {
    const double scale = 0.5 / y.half;
    for (int j = 0; j <= y.densities; ++j) {
      const ElementPotential::Values of = potential.of(j);
      sums.addInner({2 * scale * of.log, -scale * of.phase.im,
                     (j == 0 ? 1.0 : 0.0) - scale * of.phase.re, of.flow,
                     -(normal.re * of.overConj.re + normal.im * of.overConj.im)},
                    x.densities, y.densities, j, weighted);
    }
  }
};

double total(const double* x) {
  return ((x[0] + x[1]) + (x[2] + x[3])) + ((x[4] + x[5]) + (x[6] + x[7]));
}

}  // namespace

void nearMoments(const Mesh& mesh, int e, int f, Tile& m, int lane) {
  const InOrder pair(mesh, e, f);
  if (e != f || mesh.lineOf(e) < 0)
    return nearMoments(mesh, e, f, nearRule(mesh, pair), m, lane);
  const Element& x = mesh[e];
  for (int i = 0; i <= x.densities; ++i)
    for (int j = 0; j <= x.densities; ++j) {
      const int at = i * Tile::stride + j;
      m.log[at][lane] = selfMoment(i, j);
      m.along[at][lane] = m.across[at][lane] = 0;
      m.direct[at][lane] = m.reverse[at][lane] = 0;
    }
  m.log[0][lane] += 4 * std::log(x.half);
}

// NOLINTNEXTLINE(readability-function-*): the pair, where, how
void nearMoments(const Mesh& mesh, int e, int f, const GradedRule& rule, Tile& m,
                 int lane) {
  const InOrder pair(mesh, e, f);
  const Element& x = mesh[pair.x];
  const Element& y = mesh[pair.y];
  const int rows = x.densities;
  const int columns = y.densities;
  const bool onLine = mesh.areOnLine(e, f);  // w·n = 0
  using Need = ElementPotential::Need;
  ElementPotential potential(y.curve, columns + (onLine ? 0 : 1),
                             onLine ? Need::Log : Need::Moments);
  Tile sums;
  const std::vector<TargetLanes> targets = seenFrom(mesh, pair.y, pair.x, rule.points);
  dispatch(Integration{x, y, rule, targets, potential, onLine, sums});
  // w/conj(w) = τ² (1 - 2 (w·n)²/r² - 2i (w·n)(w·τ)/r²) for the tangents of y and of F
  const Complex turn = asComplex(y.curve.frame().tangent) *
                       std::conj(asComplex(mesh[f].curve.frame().tangent));
  const Complex turned = pair.transposed && !onLine ? turn * turn : 1;
  auto* const direct = pair.transposed ? m.reverse : m.direct;
  auto* const reverse = pair.transposed ? m.direct : m.reverse;
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j <= columns; ++j) {
      const int from = i * Tile::stride + j;
      const int at = pair.transposed ? j * Tile::stride + i : from;
      m.log[at][lane] = total(sums.log[from]);
      const double constant = i == 0 && j == 0 ? 2 : 0;
      const Complex phase =
          turned * Complex(constant - total(sums.across[from]), -total(sums.along[from]));
      m.across[at][lane] = constant - phase.real();
      m.along[at][lane] = -phase.imag();
      direct[at][lane] = total(sums.direct[from]);
      reverse[at][lane] = total(sums.reverse[from]);
    }
}

}  // namespace epafi::bem
