#include "bem/operators/EnergyNorm.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/moments/Tile.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace epafi::bem {

namespace {

/// Σ over all pairs (e, f) with f <= e of what they add to the two forms.
class PairSum {
 public:
  PairSum(const CauchyData& data, const Lame& lame) : data_(data), lame_(lame) {}

  double row(int e, const ElementRuns& runs, Tile& tile) const {
    double sum = 0;
    for (int r = 0; r <= runs.runOf(e); ++r) {
      const int last = std::min(runs[r].last, e + 1);
      tile.evaluate(e, r, {runs[r].first, last});
      for (int f = runs[r].first; f < last; ++f)
        sum += (e == f ? 1 : 2) * pair(e, f, f - runs[r].first, tile.moments());
    }
    return sum;
  }

 private:
  /// ∫∫ a·(-log r I + c d d'/r²) b over both elements, for slopes (V*) and densities (V);
  /// in complex numbers  a·(d d'/r²) b = ½ Re(conj(a) b + conj(a) conj(b) w/conj(w)).
  double pair(int e, int f, int lane, const TileMoments& m) const {
    const Element& x = data_.mesh[e];
    const Element& y = data_.mesh[f];
    const LocalField& a = data_.fields[static_cast<std::size_t>(e)];
    const LocalField& b = data_.fields[static_cast<std::size_t>(f)];
    const Complex tangent = asComplex(y.curve.frame().tangent);
    double sum = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(x.densities); ++i)
      for (std::size_t j = 0; j < static_cast<std::size_t>(y.densities); ++j) {
        const int row = static_cast<int>(i);
        const int column = static_cast<int>(j);
        const double whole = i == 0 && j == 0 ? 4 : 0;
        const double log = m.log[row * TileMoments::stride + column][lane];
        const Complex phase = m.phase(row, column, lane, tangent);
        const auto form = [&](Complex p, Complex q, double isotropic, double radial) {
          const double product = std::real(std::conj(p) * q);
          const double turned = std::real(std::conj(p) * std::conj(q) * phase);
          return -isotropic * log * product + 0.5 * radial * (whole * product + turned);
        };
        sum += form(a.density[i], b.density[j], lame_.a, lame_.b) +
               form(a.slope[i], b.slope[j], lame_.d, lame_.d);
      }
    return x.half * y.half * sum;
  }

  const CauchyData& data_;
  const Lame& lame_;
};

}  // namespace

double energyNorm(const CauchyData& data, const Lame& lame) {
  const PairSum pairs(data, lame);
  const ElementRuns runs(data.mesh);
  Vector rows(data.fields.size());
  const Index count = data.mesh.size();
  constexpr double ofPair = 500;  // ns
  const double work = 0.5 * ofPair * static_cast<double>(count * count);
  parallelFor(
      {count, work}, [&] { return Tile(runs); },
      [&](Tile& tile, Index k) {  // the longest rows first
        const Index e = count - 1 - k;
        rows[at(e)] = pairs.row(asInt(e), runs, tile);
      });
  return std::sqrt(std::max(0.0, std::accumulate(rows.begin(), rows.end(), 0.0)));
}

}  // namespace epafi::bem
