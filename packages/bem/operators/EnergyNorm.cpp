#include "bem/operators/EnergyNorm.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/moments/Tile.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::bem {

namespace {

/// ∫∫ a·(-log r I + c d d'/r²) b over both elements, for slopes (V*) and densities (V);
/// in complex numbers  a·(d d'/r²) b = ½ Re(conj(a) b + conj(a) conj(b) w/conj(w)).
double formsOf(const CauchyData& data, const Lame& lame, int e, int f, int lane,
               const Tile& m) {
  const Element& x = data.mesh[e];
  const Element& y = data.mesh[f];
  const LocalField& a = data.fields[at(e)];
  const LocalField& b = data.fields[at(f)];
  const Complex tangent = asComplex(y.curve.frame().tangent);
  double sum = 0;
  for (int i = 0; i < x.densities; ++i)
    for (int j = 0; j < y.densities; ++j) {
      const double whole = i == 0 && j == 0 ? 4 : 0;
      const double log = m.log[i * Tile::stride + j][lane];
      const Complex phase = m.phase(i, j, lane, tangent);
      const auto form = [&](Complex p, Complex q, double isotropic, double radial) {
        const double product = std::real(std::conj(p) * q);
        const double turned = std::real(std::conj(p) * std::conj(q) * phase);
        return -isotropic * log * product + 0.5 * radial * (whole * product + turned);
      };
      sum += form(a.density[at(i)], b.density[at(j)], lame.a, lame.b) +
             form(a.slope[at(i)], b.slope[at(j)], lame.d, lame.d);
    }
  return x.half * y.half * sum;
}

}  // namespace

double energyNorm(const CauchyData& data, const Lame& lame) {
  const ElementRuns runs(data.mesh);
  Vector rows(data.fields.size());
  const Index count = data.mesh.size();
  constexpr double ofPair = 500;  // ns
  const double work = 0.5 * ofPair * static_cast<double>(count * count);
  parallelFor(
      {count, work}, [] { return Tile(); },
      [&](Tile& tile, Index k) {  // the longest rows first
        const int e = asInt(count - 1 - k);
        for (int r = 0; r <= runs.runOf(e); ++r) {
          const int last = std::min(runs[r].last, e + 1);
          tile.evaluate(runs, e, r, {runs[r].first, last});
          for (int f = runs[r].first; f < last; ++f)
            rows[at(e)] +=
                (e == f ? 1 : 2) * formsOf(data, lame, e, f, f - runs[r].first, tile);
        }
      });
  return std::sqrt(std::max(0.0, std::accumulate(rows.begin(), rows.end(), 0.0)));
}

}  // namespace epafi::bem
