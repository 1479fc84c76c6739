#include "bem/moments/NearPairs.hpp"

#include "bem/moments/ElementPotential.hpp"
#include "bem/moments/LegendreLanes.hpp"
#include "bem/moments/RelativeTarget.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

namespace {

constexpr int stride = TileMoments::stride;

// ∫ P_n Q_m dt over [-1,1] for n + m odd, principal value.            [DLMF 14.17.9]
double integralPQ(int n, int m) { return 2.0 / ((n - m) * (n + m + 1.0)); }

// An element with itself:  log|w| = log(h/2) + log|s-t|,  w/conj(w) = τ²,  w·n = 0.
double selfMoment(int i, int j) {
  if ((i + j) % 2 == 1)
    return 0;
  if (j == 0)
    return i == 0 ? 4 * std::log(2.0) - 6
                  : 2 * (integralPQ(0, i + 1) - integralPQ(0, i - 1)) / (2 * i + 1);
  return 2 * (integralPQ(i, j + 1) - integralPQ(i, j - 1)) / (2 * j + 1);
}

/// What is integrated over the outer element x and the inner one y.
enum Table { Log, Along, Across, Direct, Reverse, Tables };

struct Shape {
  int rows;     ///< densities on x
  int columns;  ///< on y
  std::size_t at(int table, int i, int j) const {
    return static_cast<std::size_t>((table * (rows + 1) + i) * (columns + 1) + j);
  }
  std::size_t size() const { return at(Tables, 0, 0); }
};

/// What the kernels read and write.
struct Work {
  const GradedRule& rule;
  const SeenPoints& seen;
  Shape shape;
  Complex turn;  ///< conj(τ_x) τ_y h_x/h_y
  AlignedLane* sums;
};

template <int Parts>
struct NearKernel {
  const Work& work;

  template <Division How>
  EPAFI_INLINE void run() const {
    const Shape shape = work.shape;
    const int rows = shape.rows;
    const int columns = shape.columns;
    Pack weighted[largestMoment + 1];
    LegendreLanes<Parts> inner;
    const auto& points = work.rule.points;
    for (std::size_t first = 0; first < points.size(); first += lanes) {
      const TargetLanes x(work.seen, first);
      inner.evaluate(x, Parts == 1 && columns == 1 ? 0 : columns);
      AlignedLane places{};
      AlignedLane weights{};
      for (std::size_t lane = 0; lane < lanes && first + lane < points.size(); ++lane) {
        places.lane[lane] = points[first + lane].t;
        weights.lane[lane] = work.rule.weights[first + lane];
      }
      const Pack t = load(places.lane);
      weighted[0] = load(weights.lane);
      weighted[1] = t * weighted[0];
      for (int k = 1; k < rows; ++k)
        weighted[k + 1] = ((2 * k + 1.0) / (k + 1)) * (t * weighted[k]) -
                          (k / (k + 1.0)) * weighted[k - 1];
      for (int j = 0; j < columns; ++j)
        for (int i = 0; i < rows; ++i)
          put(Log, i, j, weighted[i] * inner.l[j]);
      if constexpr (Parts == 2)
        for (int j = 0; j <= columns; ++j) {
          const Pack real = inner.c[0][j];
          const Pack imag = inner.c[1][j];
          for (int i = 0; i < rows; ++i)
            put(Direct, i, j, -weighted[i] * imag);
          if (j == columns)
            continue;
          const Pack along = x.b * real;
          const Pack across = -x.b * imag;
          const Pack reverse = work.turn.real() * imag + work.turn.imag() * real;
          for (int i = 0; i < rows; ++i) {
            put(Along, i, j, weighted[i] * along);
            put(Across, i, j, weighted[i] * across);
          }
          for (int i = 0; i <= rows; ++i)
            put(Reverse, i, j, weighted[i] * reverse);
        }
    }
  }

  EPAFI_INLINE void put(int table, int i, int j, const Pack& value) const {
    add(work.sums[work.shape.at(table, i, j)].lane, value);
  }
};

/// 1e-13 of the moments' norm with polynomials of both degrees: where the elements touch,
/// integrands are like log s in the distance s, on one edge like s log s.
GradedRule nearRule(const Mesh& mesh, int outer, int inner, bool hasArc, bool onEdge) {
  std::vector<Feature> features;
  appendEnds(mesh, outer, inner, features);
  const int degree = mesh[outer].densities + mesh[inner].densities + (hasArc ? 6 : 0);
  return touchingRule(
      features, 17 + degree / 2,
      onEdge ? Softening{5, 20 + 7 * degree / 6} : Softening{7, 26 + 27 * degree / 20});
}

double total(const AlignedLane& sums) {
  const double* x = sums.lane;
  return ((x[0] + x[1]) + (x[2] + x[3])) + ((x[4] + x[5]) + (x[6] + x[7]));
}

}  // namespace

void NearMoments::evaluate(const Mesh& mesh, int e, int f, TileMoments& m, int lane,
                           InstructionSet set) {
  // the smaller element outside: the potential of the larger one is smoother on it
  const bool transposed = mesh[e].half > mesh[f].half;
  const int outer = transposed ? f : e;
  const int inner = transposed ? e : f;
  const Element& x = mesh[outer];
  const Element& y = mesh[inner];
  const bool hasArc = !x.curve.isStraight() || !y.curve.isStraight();
  const bool onEdge = x.piece.edge == y.piece.edge;
  const bool onLine = onEdge && !hasArc;
  if (onLine)  // w·n = 0
    for (int i = 0; i <= mesh[e].densities; ++i)
      for (int j = 0; j <= mesh[f].densities; ++j) {
        const int at = i * stride + j;
        m.along[at][lane] = m.across[at][lane] = 0;
        m.direct[at][lane] = m.reverse[at][lane] = 0;
        m.log[at][lane] = e == f ? selfMoment(i, j) : 0;
      }
  if (onLine && e == f) {
    m.log[0][lane] += 4 * std::log(x.half);
    return;
  }
  const GradedRule rule = nearRule(mesh, outer, inner, hasArc, onEdge);
  if (hasArc)
    return nearArcMoments(mesh, e, f, rule, m, lane);
  const Shape shape = {x.densities, y.densities};
  sums_.assign(shape.size(), AlignedLane{});
  const SeenPoints seen(mesh, outer, inner, rule.points);
  const Complex tangentX = asComplex(x.curve.frame().tangent);
  const Complex tangentY = asComplex(y.curve.frame().tangent);
  const Work work = {rule, seen, shape, x.half / y.half * std::conj(tangentX) * tangentY,
                     sums_.data()};
  if (onLine)
    dispatch(set, NearKernel<1>{work});
  else
    dispatch(set, NearKernel<2>{work});
  const auto sum = [&](int table, int i, int j) {
    return total(sums_[shape.at(table, i, j)]);
  };
  // w/conj(w) = τ² (1 - 2 (w·n)²/r² - 2i (w·n)(w·τ)/r²) for either element's τ
  const Complex turned = std::pow(tangentY * std::conj(tangentX), 2);
  m.setPair(x.densities, y.densities, transposed, lane, [&](int i, int j) {
    const double constant = i == 0 && j == 0 ? 4 : 0;
    Complex phase(constant - 2 * sum(Across, i, j), -2 * sum(Along, i, j));
    if (transposed)
      phase *= turned;
    return PairSums{sum(Log, i, j) + constant * std::log(y.half), phase,
                    sum(Direct, i, j), sum(Reverse, i, j)};
  });
}

void nearArcMoments(const Mesh& mesh, int e, int f, const GradedRule& outer,
                    TileMoments& m, int lane) {
  const bool transposed = mesh[e].half > mesh[f].half;
  const int ix = transposed ? f : e;
  const int iy = transposed ? e : f;
  const Element& x = mesh[ix];
  const Element& y = mesh[iy];
  const int rows = x.densities;
  const int columns = y.densities;
  const SeenPoints seen(mesh, ix, iy, outer.points);
  ElementPotential inner(y.curve, columns + 1, ElementPotential::Need::All);
  std::vector<PairSums> sums(static_cast<std::size_t>((rows + 1) * (columns + 1)));
  double legendre[TileMoments::stride];
  for (std::size_t q = 0; q < outer.points.size(); ++q) {
    if (q % lanes == 0)
      inner.evaluate(seen, q);
    const double t = outer.points[q].t;
    const Complex normal = x.half / y.half * asComplex(x.curve.normal(t));
    legendreValues(rows, t, legendre);
    for (int j = 0; j <= columns; ++j) {
      const ElementPotential::Values of = inner.at(j, q % lanes);
      const double reverse = -std::real(normal * std::conj(of.overConj));
      for (int i = 0; i <= rows; ++i) {
        PairSums& to = sums[static_cast<std::size_t>(i * (columns + 1) + j)];
        const double p = outer.weights[q] * legendre[i];
        to.log += p / y.half * of.log;
        to.phase += p / y.half * of.phase;
        to.direct += p * of.flow;
        to.reverse += p * reverse;
      }
    }
  }
  const Complex tangent = asComplex(mesh[f].curve.frame().tangent);
  const Complex back = std::conj(tangent * tangent);
  m.setPair(rows, columns, transposed, lane, [&](int i, int j) {
    PairSums own = sums[static_cast<std::size_t>(i * (columns + 1) + j)];
    own.phase *= back;
    return own;
  });
}

}  // namespace epafi::bem
