#include "bem/operators/EnergyNorm.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/moments/RingTile.hpp"
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

/// The same for solids of revolution, with the radial displacements that W has beside slopes.
double formsOf(const CauchyData& data, const Lame& /*lame*/, int e, int f, int lane,
               const RingTile& m) {
  using Kernels = RingKernels;
  const RingLame& lame = m.lame();
  const Element& x = data.mesh[e];
  const Element& y = data.mesh[f];
  const LocalField& a = data.fields[at(e)];
  const LocalField& b = data.fields[at(f)];
  double sum = 0;
  for (int i = 0; i <= x.densities; ++i)
    for (int j = 0; j <= y.densities; ++j) {
      const auto of = [&](int kernel) { return m.at(kernel, i, j)[lane]; };
      const auto form = [&](Complex p, Complex q, double radial, double axial,
                            double mixed) {
        return p.real() * (q.real() * radial + q.imag() * mixed * of(Kernels::rz)) +
               p.imag() * (q.real() * mixed * of(Kernels::zr) + q.imag() * axial);
      };
      const Complex u = a.slope[at(i)];
      const Complex v = b.slope[at(j)];
      const double p = a.value[at(i)].real();
      const double q = b.value[at(j)].real();
      const double rr = of(Kernels::rr);
      const double zz = of(Kernels::zz);
      const double e1 = of(Kernels::e1);
      const double e0 = of(Kernels::e0);
      sum +=
          form(a.density[at(i)], b.density[at(j)], lame.a * e1 + lame.b * rr,
               lame.a * e0 + lame.b * zz, lame.b) +
          u.real() * v.real() *
              (lame.curl * (e0 - of(Kernels::es)) -
               lame.squared * (lame.part * e0 + zz)) +
          u.imag() * v.imag() * (lame.curl * e1 - lame.squared * (lame.part * e1 + rr)) +
          lame.squared * (u.real() * v.imag() * of(Kernels::zr) +
                          u.imag() * v.real() * of(Kernels::rz)) +
          q * (u.real() * of(Kernels::ySlope) + u.imag() * of(Kernels::ySlope + 1)) +
          p * (v.real() * of(Kernels::xSlope) + v.imag() * of(Kernels::xSlope + 1)) +
          p * q * of(Kernels::both);
    }
  constexpr double turn = 6.2831853071795865;
  return turn * x.half * y.half * sum;
}

/// \param tileOf  of a thread
template <class TileOf>
double normOf(const CauchyData& data, const Lame& lame, const TileOf& tileOf) {
  const ElementRuns runs(data.mesh);
  Vector rows(data.fields.size());
  const Index count = data.mesh.size();
  constexpr double ofPair = 500;  // ns
  const double work = 0.5 * ofPair * static_cast<double>(count * count);
  parallelFor({count, work}, tileOf, [&](auto& tile, Index k) {  // the longest rows first
    const int e = asInt(count - 1 - k);
    if (data.mesh.isAxis(e))  // a circle of radius zero: no moments
      return;
    for (int r = 0; r <= runs.runOf(e); ++r) {
      const int last = std::min(runs[r].last, e + 1);
      tile.evaluate(runs, e, r, {runs[r].first, last});
      for (int f = runs[r].first; f < last; ++f)
        if (!data.mesh.isAxis(f))
          rows[at(e)] +=
              (e == f ? 1 : 2) * formsOf(data, lame, e, f, f - runs[r].first, tile);
    }
  });
  return std::sqrt(std::max(0.0, std::accumulate(rows.begin(), rows.end(), 0.0)));
}

}  // namespace

double energyNorm(const CauchyData& data, const Lame& lame) {
  return data.mesh.outline().isAxisymmetric()
             ? normOf(data, lame, [&] { return RingTile(lame); })
             : normOf(data, lame, [] { return Tile(); });
}

}  // namespace epafi::bem
