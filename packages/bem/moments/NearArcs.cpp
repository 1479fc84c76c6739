#include "bem/moments/ElementPotential.hpp"
#include "bem/moments/NearPairs.hpp"

#include <cmath>

namespace epafi::bem {

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
