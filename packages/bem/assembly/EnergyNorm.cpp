#include "bem/assembly/EnergyNorm.hpp"

#include "bem/assembly/FarPairs.hpp"
#include "bem/assembly/NearPair.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

namespace epafi::bem {

namespace {

/// Scratch of one thread.
struct Moments {
  PairMoments pair;
  FarMoments far;
};

/// Σ over all pairs (e, f) with f <= e of what they add to the two forms.
class PairSum {
 public:
  PairSum(const CauchyData& data, const Lame& lame) : data_(data), lame_(lame) {}

  double row(int e, Moments& moments) const {
    double sum = 0;
    for (int first = 0; first <= e; first += lanes)
      sum += batch(e, first, std::min(first + lanes, e + 1), moments);
    return sum;
  }

 private:
  double batch(int e, int first, int last, Moments& moments) const {
    const Mesh& mesh = data_.mesh;
    FarBatch batch;
    PairOrder order;
    int columns = 0;
    bool near[lanes];
    for (int lane = 0; lane < lanes; ++lane) {
      const int f = first + lane;
      PairOrder own;
      near[lane] = f >= last || isNear(mesh, e, f, own);
      setLane(batch, lane, e, near[lane] ? -1 : f);
      if (near[lane])
        continue;
      order = {std::max(order.outer, own.outer), std::max(order.inner, own.inner)};
      columns = std::max(columns, mesh[f].degree);
    }
    if (columns > 0)
      farMoments(mesh[e], batch, mesh[e].degree, columns, order, moments.far);
    double sum = 0;
    for (int f = first; f < last; ++f) {
      if (near[f - first])
        nearPairMoments(mesh, e, f, moments.pair);
      else
        extractLane(moments.far, f - first, mesh[f].tangent, mesh[e].degree,
                    mesh[f].degree, moments.pair);
      sum += (e == f ? 1 : 2) * pair(e, f, moments.pair);
    }
    return sum;
  }

  // f < 0: a lane to be thrown away, far off so that nothing overflows
  void setLane(FarBatch& batch, int lane, int e, int f) const {
    const Mesh& mesh = data_.mesh;
    const Vec2 w = f < 0 ? Vec2{10, 10} : mesh.difference(mesh.at(e, 0), mesh.at(f, 0));
    const Vec2 tangent = f < 0 ? Vec2{1, 0} : mesh[f].tangent;
    batch.wx[lane] = w.x;
    batch.wy[lane] = w.y;
    batch.tx[lane] = tangent.x;
    batch.ty[lane] = tangent.y;
    batch.half[lane] = f < 0 ? 1 : mesh[f].half;
  }

  /// ∫∫ a·(-log r I + c d d'/r²) b over both elements, for slopes (V*) and densities (V);
  /// in complex numbers  a·(d d'/r²) b = ½ Re(conj(a) b + conj(a) conj(b) w/conj(w)).
  double pair(int e, int f, const PairMoments& m) const {
    const Element& x = data_.mesh[e];
    const Element& y = data_.mesh[f];
    const LocalField& a = data_.fields[static_cast<std::size_t>(e)];
    const LocalField& b = data_.fields[static_cast<std::size_t>(f)];
    double sum = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(x.degree); ++i)
      for (std::size_t j = 0; j < static_cast<std::size_t>(y.degree); ++j) {
        const int row = static_cast<int>(i);
        const int column = static_cast<int>(j);
        const double whole = i == 0 && j == 0 ? 4 : 0;
        const double log = m.log(row, column);
        const Complex phase(m.phaseReal(row, column), m.phaseImag(row, column));
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
  Vector rows(data.fields.size());
#pragma omp parallel
  {
    const auto moments = std::make_unique<Moments>();
#pragma omp for schedule(dynamic, 1)
    for (int e = data.mesh.size() - 1; e >= 0; --e)
      rows[static_cast<std::size_t>(e)] = pairs.row(e, *moments);
  }
  return std::sqrt(std::max(0.0, std::accumulate(rows.begin(), rows.end(), 0.0)));
}

}  // namespace epafi::bem
