#include "bem/potential/PointSources.hpp"

namespace epafi::bem {

namespace {

constexpr Complex i(0, 1);

#define EPAFI_INLINE inline __attribute__((always_inline))

struct Columns {
  const double* x;
  const double* y;
  const double* fx;
  const double* fy;
  const double* sx;
  const double* sy;
  std::size_t size;
};

/// 1/w = a - ib,  1/conj(w) = a + ib,  w/conj(w)² = gx + i gy.
EPAFI_INLINE FieldSums sum(const Columns& c, double x, double y) {
  double f[6] = {0, 0, 0, 0, 0, 0};
  double s[6] = {0, 0, 0, 0, 0, 0};
#pragma omp simd reduction(+ : f[:6], s[:6])
  for (std::size_t k = 0; k < c.size; ++k) {
    const double wx = x - c.x[k];
    const double wy = y - c.y[k];
    const double inverse = 1 / (wx * wx + wy * wy);
    const double a = wx * inverse;
    const double b = wy * inverse;
    const double ex = a * wx - b * wy;
    const double ey = a * wy + b * wx;
    const double gx = ex * a - ey * b;
    const double gy = ex * b + ey * a;
    const double fx = c.fx[k];
    const double fy = c.fy[k];
    f[0] += fx * a + fy * b;
    f[1] += fy * a - fx * b;
    f[2] += fx * a - fy * b;
    f[3] += fy * a + fx * b;
    f[4] += gx * fx + gy * fy;
    f[5] += gy * fx - gx * fy;
    const double sx = c.sx[k];
    const double sy = c.sy[k];
    s[0] += sx * a + sy * b;
    s[1] += sy * a - sx * b;
    s[2] += sx * a - sy * b;
    s[3] += sy * a + sx * b;
    s[4] += gx * sx + gy * sy;
    s[5] += gy * sx - gx * sy;
  }
  return {{{f[0], f[1]}, {f[2], f[3]}, {f[4], f[5]}},
          {{s[0], s[1]}, {s[2], s[3]}, {s[4], s[5]}}};
}

// GCC would take vectors of four on processors that clock down for those of eight.
#ifdef __clang__
#define EPAFI_WIDE_AVX512 "avx512f,avx512dq,avx512vl,fma"
#else
#define EPAFI_WIDE_AVX512 "avx512f,avx512dq,avx512vl,fma,prefer-vector-width=512"
#endif
__attribute__((target(EPAFI_WIDE_AVX512))) FieldSums sumAvx512(const Columns& c, double x,
                                                               double y) {
  return sum(c, x, y);
}

__attribute__((target("avx2,fma"))) FieldSums sumAvx2(const Columns& c, double x,
                                                      double y) {
  return sum(c, x, y);
}

FieldSums sumBaseline(const Columns& c, double x, double y) { return sum(c, x, y); }

/// ∫ Re(τ/w) g ds
Complex alongTangent(Complex tangent, const SourceSums& g) {
  return 0.5 * (tangent * g.overW + std::conj(tangent) * g.overConj);
}

/// ∫ conj(g) (τ/conj(w) - conj(τ) w/conj(w)²) ds
Complex turned(Complex tangent, const SourceSums& g) {
  return tangent * std::conj(g.overW) - std::conj(tangent) * g.cubic;
}

}  // namespace

Complex traction(const Lame& lame, Complex normal, const FieldSums& sums) {
  const SourceSums& f = sums.density;
  const Complex tangent = i * normal;
  const Complex adjoint =
      -2 * lame.mu * lame.b * f.overW.real() * normal -
      lame.mu * std::conj(normal) * (lame.a * f.overConj + lame.b * f.cubic);
  return adjoint +
         lame.d * (alongTangent(tangent, sums.slope) - 0.5 * turned(tangent, sums.slope));
}

Complex mismatchSlope(const Lame& lame, Complex normal, const FieldSums& sums) {
  const Complex tangent = i * normal;
  const SourceSums& s = sums.slope;
  const Complex single = -lame.a * alongTangent(tangent, sums.density) +
                         0.5 * lame.b * turned(tangent, sums.density);
  const Complex twice = i * lame.mu *
                        (lame.b * std::conj(tangent) * s.overConj -
                         lame.a * tangent * s.overW - lame.b * turned(tangent, s));
  return single - twice;
}

void PointSources::clear() {
  for (auto& array : data_)
    array.clear();
}

void PointSources::add(Complex place, Complex density, Complex slope) {
  data_[X].push_back(place.real());
  data_[Y].push_back(place.imag());
  data_[DensityX].push_back(density.real());
  data_[DensityY].push_back(density.imag());
  data_[SlopeX].push_back(slope.real());
  data_[SlopeY].push_back(slope.imag());
}

FieldSums PointSources::at(Complex x, InstructionSet set) const {
  const Columns columns = {data_[X].data(),        data_[Y].data(),
                           data_[DensityX].data(), data_[DensityY].data(),
                           data_[SlopeX].data(),   data_[SlopeY].data(),
                           data_[X].size()};
  switch (set) {
    case InstructionSet::Avx512:
      return sumAvx512(columns, x.real(), x.imag());
    case InstructionSet::Avx2:
      return sumAvx2(columns, x.real(), x.imag());
    case InstructionSet::Baseline:
      break;
  }
  return sumBaseline(columns, x.real(), x.imag());
}

}  // namespace epafi::bem
