#include "bem/moments/ArcPairs.hpp"
#include "bem/moments/ElementPotential.hpp"

#include <cmath>

namespace epafi::bem {

namespace {

constexpr int stride = TileMoments::stride;

/// ∫ P_j τ dt of an element, j below its densities.
std::vector<Complex> tangentMoments(const Element& e) {
  const ArcRule rule(e.curve, e.densities);
  std::vector<Complex> moments(static_cast<std::size_t>(e.densities));
  for (int q = 0; q < rule.size(); ++q)
    for (int j = 0; j < e.densities; ++j)
      moments[j] += rule.weight(q) * rule.legendre(q, j) * rule.tangent(q);
  return moments;
}

}  // namespace

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
  double legendre[stride];
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

// (w·n)/|w|² = -κ/2 with the normal at either end,  w/conj(w) = τ_x τ_y
void bendMoments(const Mesh& mesh, int e, int f, TileMoments& m, int lane) {
  const Element& x = mesh[e];
  const Element& y = mesh[f];
  const double alpha = 0.5 * y.curve.angle();
  const double middle = seenFrom(mesh, f, mesh.at(e, 0)).z().real();
  const double ratio = x.half / y.half;
  constexpr int forSinc = 22;
  const Rule& rule = gaussLegendre(forSinc + (x.densities + y.densities) / 2);
  double outer[stride];
  double inner[stride];
  for (int q = 0; q < rule.size(); ++q) {
    const double s = rule.points[q];
    std::array<double, stride> logs{};
    for (int k = 0; k < rule.size(); ++k) {
      const double t = rule.points[k];
      const double angle = 0.5 * alpha * (middle + ratio * s - t);
      const double log = angle == 0 ? 0 : std::log(std::abs(std::sin(angle) / angle));
      legendreValues(y.densities, t, inner);
      for (int j = 0; j < y.densities; ++j)
        logs[j] += rule.weights[k] * inner[j] * log;
    }
    legendreValues(x.densities, s, outer);
    for (int i = 0; i < x.densities; ++i)
      for (int j = 0; j < y.densities; ++j)
        m.log[i * stride + j][lane] += rule.weights[q] * outer[i] * logs[j];
  }
  m.direct[0][lane] = -y.curve.angle();
  m.reverse[0][lane] = -x.curve.angle();
  const std::vector<Complex> tangentsX = tangentMoments(x);
  const std::vector<Complex> tangentsY = tangentMoments(y);
  const Complex tangent = asComplex(y.curve.frame().tangent);
  const Complex back = std::conj(tangent * tangent);
  for (int i = 0; i < x.densities; ++i)
    for (int j = 0; j < y.densities; ++j)
      m.setPhase(back * (tangentsX[i] * tangentsY[j]), i * stride + j, lane);
}

}  // namespace epafi::bem
