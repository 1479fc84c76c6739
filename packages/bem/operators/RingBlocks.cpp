#include "bem/operators/RingBlocks.hpp"

#include "bem/basis/Legendre.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

constexpr double turn = 6.2831853071795865;
using Kernels = RingKernels;

}  // namespace

/// r, z: components; a block [c, d] has a test function c of a lane and a trial function d of f.
template <int Degree>
class RingBlocks::Filling {
 public:
  EPAFI_INLINE Filling(RingBlocks& to, const RingTile& tile, const AlignedLane& wanted,
                       const AlignedLane& others)
      : to_(to),
        tile_(tile),
        lame_(tile.lame()),
        f_(to.space_.mesh()[tile.trial()]),
        densities_{to_.densityStarts_.data(), to_.densityCounts_.data(), to_.lastLane()},
        displacements_{to_.displacementStarts_.data(), to_.degrees_.data(),
                       to_.lastLane()},
        half_(load(to.run_->half)),
        wanted_(turn * load(wanted.lane)),
        others_(turn * load(others.lane)) {}

  EPAFI_INLINE void fill() const {
    const int columns = to_.run_->densities;
    const int displacements = to_.run_->degree;
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < f_.densities; ++i)
        putSingleLayer(i, j);
      for (int k = 0; k <= f_.degree; ++k)
        putDoubleLayer(k, j);
    }
    for (int j = 0; j < displacements; ++j) {
      for (int i = 0; i < f_.densities; ++i)
        putTransposed(i, j);
      for (int k = 0; k <= f_.degree; ++k)
        putHypersingular(k, j);
    }
  }

 private:
  /// Of a test function's components with a trial function of one component.
  struct Components {
    Pack r;
    Pack z;
  };

  EPAFI_INLINE const Pack& of(int kernel, int i, int j) const {
    return load(tile_.at(kernel, i, j));
  }
  /// (1-2ν)(E₁, E₀) + P on the diagonal
  EPAFI_INLINE void radial(int i, int j, Pack& to) const {
    to = lame_.part * of(Kernels::e1, i, j) + of(Kernels::rr, i, j);
  }
  EPAFI_INLINE void axial(int i, int j, Pack& to) const {
    to = lame_.part * of(Kernels::e0, i, j) + of(Kernels::zz, i, j);
  }
  EPAFI_INLINE static int slopeOf(int k) { return k > 1 ? k - 1 : 0; }
  EPAFI_INLINE double scale(int k) const { return to_.functionSlopes_[k]; }

  /// φ_k of f from Legendre polynomials.
  EPAFI_INLINE void onTrial(int kernel, int k, int j, Pack& to) const {
    if (k < 2)
      to = 0.5 * (of(kernel, 0, j) + (k == 0 ? -1.0 : 1.0) * of(kernel, 1, j));
    else
      to = (scale(k) / (2 * k - 1)) * (of(kernel, k, j) - of(kernel, k - 2, j));
  }
  /// φ_l of the lanes.
  EPAFI_INLINE void onTest(int kernel, int i, int l, Pack& to) const {
    if (l < 2)
      to = 0.5 * (of(kernel, i, 0) + (l == 0 ? -1.0 : 1.0) * of(kernel, i, 1));
    else
      to = (scale(l) / (2 * l - 1)) * (of(kernel, i, l) - of(kernel, i, l - 2));
  }
  EPAFI_INLINE void onBoth(int kernel, int k, int l, Pack& to) const {
    Pack low;
    Pack high;
    if (k < 2) {
      onTest(kernel, 0, l, low);
      onTest(kernel, 1, l, high);
      to = 0.5 * (low + (k == 0 ? -1.0 : 1.0) * high);
    } else {
      onTest(kernel, k - 2, l, low);
      onTest(kernel, k, l, high);
      to = (scale(k) / (2 * k - 1)) * (high - low);
    }
  }

  EPAFI_INLINE void putSingleLayer(int i, int j) const {
    const Pack area = wanted_ * f_.half * half_;
    double* to = to_.first(to_.single_, i);
    const Pack rr = lame_.a * of(Kernels::e1, i, j) + lame_.b * of(Kernels::rr, i, j);
    const Pack zz = lame_.a * of(Kernels::e0, i, j) + lame_.b * of(Kernels::zz, i, j);
    const Pack mixed = area * lame_.b;
    densities_.put(area * rr, mixed * of(Kernels::rz, i, j), j, to);
    densities_.put(mixed * of(Kernels::zr, i, j), area * zz, j, to + to_.longest_);
  }

  // source on f, target on the lanes
  EPAFI_INLINE void putDoubleLayer(int k, int j) const {
    const int i = slopeOf(k);
    const Pack edge = wanted_ * half_ * (scale(k) * lame_.doubled);
    const Pack area = wanted_ * half_ * f_.half;
    Pack rr;
    Pack zz;
    Pack functions[3];
    radial(i, j, rr);
    axial(i, j, zz);
    for (int a = 0; a < 3; ++a)
      onTrial(Kernels::ofX + a, k, j, functions[a]);
    double* to = to_.first(to_.double_, k);
    densities_.put(edge * of(Kernels::zr, i, j) + area * functions[0],
                   edge * zz + area * functions[1], j, to);
    densities_.put(-edge * rr, area * functions[2] - edge * of(Kernels::rz, i, j), j,
                   to + to_.longest_);
  }

  /// Target on f, source φ_l of the lanes: components of the source, of both rows of the target.
  EPAFI_INLINE void sourceOnLanes(int i, int l, Components& ofR, Components& ofZ) const {
    const int j = slopeOf(l);
    const Pack edge = others_ * (f_.half * scale(l) * lame_.doubled);
    const Pack area = others_ * half_ * f_.half;
    Pack rr;
    Pack zz;
    Pack functions[3];
    radial(i, j, rr);
    axial(i, j, zz);
    for (int a = 0; a < 3; ++a)
      onTest(Kernels::ofY + a, i, l, functions[a]);
    ofR = {edge * of(Kernels::rz, i, j) + area * functions[0], -edge * rr};
    ofZ = {edge * zz + area * functions[1],
           area * functions[2] - edge * of(Kernels::zr, i, j)};
  }

  /// Both rows of what stands for j: of φ_{j+1} of the lanes, of both nodes' for j = 0.
  /// \param of  (l, ofR, ofZ) computes the rows of φ_l
  template <class Of>
  EPAFI_INLINE void putDisplacements(int j, const Of& of, double* to) const {
    Components r[2];
    Components z[2];
    of(j + 1, r[1], z[1]);
    if (j > 0) {
      displacements_.put(r[1].r, r[1].z, j, to);
      displacements_.put(z[1].r, z[1].z, j, to + to_.longest_);
      return;
    }
    of(0, r[0], z[0]);
    displacements_.putNodes(r[0].r, r[0].z, r[1].r, r[1].z, to);
    displacements_.putNodes(z[0].r, z[0].z, z[1].r, z[1].z, to + to_.longest_);
  }

  EPAFI_INLINE void putTransposed(int i, int j) const {
    const auto source = [&](int l, Components& r, Components& z) {
      sourceOnLanes(i, l, r, z);
    };
    putDisplacements(j, source, to_.first(to_.transposed_, i));
  }

  /// Of φ_k of f and φ_l of the lanes.
  EPAFI_INLINE void products(int k, int l, Components& ofR, Components& ofZ) const {
    const int i = slopeOf(k);
    const int j = slopeOf(l);
    const Pack slopes = wanted_ * (scale(k) * scale(l));
    const Pack ofTrial = wanted_ * (scale(l) * f_.half);  // φ_k φ_l'
    const Pack ofTest = wanted_ * half_ * scale(k);       // φ_k' φ_l
    const Pack area = wanted_ * half_ * f_.half;
    Pack rr;
    Pack zz;
    Pack x[2];
    Pack y[2];
    Pack both;
    radial(i, j, rr);
    axial(i, j, zz);
    for (int a = 0; a < 2; ++a) {
      onTrial(Kernels::xSlope + a, k, j, x[a]);
      onTest(Kernels::ySlope + a, i, l, y[a]);
    }
    onBoth(Kernels::both, k, l, both);
    const Pack radialSlopes =
        lame_.curl * (of(Kernels::e0, i, j) - of(Kernels::es, i, j)) - lame_.squared * zz;
    const Pack axialSlopes = lame_.curl * of(Kernels::e1, i, j) - lame_.squared * rr;
    ofR = {slopes * radialSlopes + ofTest * y[0] + ofTrial * x[0] + area * both,
           lame_.squared * slopes * of(Kernels::zr, i, j) + ofTrial * x[1]};
    ofZ = {lame_.squared * slopes * of(Kernels::rz, i, j) + ofTest * y[1],
           slopes * axialSlopes};
  }

  EPAFI_INLINE void putHypersingular(int k, int j) const {
    const auto product = [&](int l, Components& r, Components& z) {
      products(k, l, r, z);
      if (k != 1 || l != 0)
        return;
      store(to_.common_[0].lane, r.r);
      store(to_.common_[1].lane, z.r);
      store(to_.common_[2].lane, r.z);
      store(to_.common_[3].lane, z.z);
    };
    putDisplacements(j, product, to_.first(to_.hypersingular_, k));
  }

  RingBlocks& to_;
  const RingTile& tile_;
  const RingLame& lame_;
  const Element& f_;
  ColumnNumbering<Degree> densities_;
  ColumnNumbering<Degree> displacements_;
  Pack half_;
  Pack wanted_;
  Pack others_;
};

struct RingBlocks::Fill {
  RingBlocks& to;
  const RingTile& tile;
  const AlignedLane& wanted;
  const AlignedLane& others;
  bool isUniform;  ///< one density on all lanes

  template <Division>
  EPAFI_INLINE void run() const {
    if (isUniform)
      Filling<1>(to, tile, wanted, others).fill();
    else
      Filling<0>(to, tile, wanted, others).fill();
  }
};

void RingBlocks::fill() {
  const RingTile& tile = tile_;
  setRun(tile.run(), tile.trial());
  const Mesh& mesh = space_.mesh();
  const int f = tile.trial();
  AlignedLane wanted{};
  AlignedLane others{};
  bool isUniform = run_->densities == 1;
  for (int lane = 0; lane < lanes; ++lane) {
    const int e = run_->first + lane;
    wanted.lane[lane] = tile.isWanted(lane) ? 1 : 0;
    others.lane[lane] = tile.isWanted(lane) && e != f ? 1 : 0;
    isUniform = isUniform && (e >= run_->last || mesh[e].densities == 1);
  }
  dispatch(Fill{*this, tile, wanted, others, isUniform});
  if (f >= run_->first && f < run_->last && tile.isWanted(f - run_->first))
    addHalf(ringMassOf(mesh, f));
}

double RingBlocks::energy(int lane, const LocalField& onTrial,
                          const LocalField& onLane) const {
  const RingLame& lame = tile_.lame();
  const Element& x = space_.mesh()[tile_.trial()];
  const Element& y = space_.mesh()[tile_.run().first + lane];
  double sum = 0;
  for (int i = 0; i <= x.densities; ++i)
    for (int j = 0; j <= y.densities; ++j) {
      const auto of = [&](int kernel) { return tile_.at(kernel, i, j)[lane]; };
      const auto form = [&](Complex p, Complex q, double radial, double axial,
                            double mixed) {
        return p.real() * (q.real() * radial + q.imag() * mixed * of(Kernels::rz)) +
               p.imag() * (q.real() * mixed * of(Kernels::zr) + q.imag() * axial);
      };
      const Complex u = onTrial.slope[at(i)];
      const Complex v = onLane.slope[at(j)];
      const double p = onTrial.value[at(i)].real();
      const double q = onLane.value[at(j)].real();
      const double rr = of(Kernels::rr);
      const double zz = of(Kernels::zz);
      const double e1 = of(Kernels::e1);
      const double e0 = of(Kernels::e0);
      sum +=
          form(onTrial.density[at(i)], onLane.density[at(j)], lame.a * e1 + lame.b * rr,
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
  return turn * x.half * y.half * sum;
}

Matrix ringMassOf(const Mesh& mesh, int e) {
  const Element& element = mesh[e];
  Matrix mass(element.densities, element.degree + 1);
  const Rule& rule =
      gaussLegendre(element.densities + 2 + element.curve.pointsOfTurning());
  std::array<double, largestDegree + 1> phi{};
  std::array<double, largestDegree + 2> legendre{};
  for (int q = 0; q < rule.size(); ++q) {
    const double t = rule.points[at(q)];
    const double weight = rule.weights[at(q)] * mesh.measure(e, t);
    DisplacementBasis::values(element.degree, t, phi.data());
    legendreValues(element.densities - 1, t, legendre.data());
    for (int i = 0; i < element.densities; ++i)
      for (int k = 0; k <= element.degree; ++k)
        mass(i, k) += weight * legendre[at(i)] * phi[at(k)];
  }
  return mass;
}

}  // namespace epafi::bem
