#pragma once

#include "bem/base/Material.hpp"
#include "bem/simd/Pack.hpp"

namespace epafi::bem {

/// Constants of the kernels, d = w, n and τ the unit normal and tangent:
///
///   V  = -A log r I + B d d'/r²
///   K  = k [(1-2ν) I + 2 d d'/r²] (d·n_y)/r² - k (1-2ν) (d n_y' - n_y d')/r²
///   K' = -k [(1-2ν) I + 2 d d'/r²] (d·n_x)/r² - k (1-2ν) (d n_x' - n_x d')/r²
///
/// and the hypersingular kernel W for continuous functions, x and y in different supports, from
/// integration by parts:                                       [doc/theory/operators.md]
///
///   W v = -D ∫ Re(τ_x τ_y/w²) v - (Re(τ_x conj(τ_y))/conj(w)² - conj(τ_x τ_y) w/conj(w)³) conj(v) ds
struct KernelConstants {
  double a;
  double b;
  double d;
  double k;
  double turn;  ///< 1 - 2ν
  explicit KernelConstants(const Lame& lame)
      : a(lame.a), b(lame.b), d(lame.d), k(2 * lame.mu * lame.b), turn(1 - 2 * lame.nu) {}
};

/// The distinct entries of the four kernels at pairs of points, see FarQuadrature.
struct KelvinPoints {
  static constexpr int components = 2;
  using Constants = KernelConstants;

  Pack v[3];  ///< -V: xx, xy, yy
  Pack k[4];  ///< K: xx, yx, xy, yy
  Pack t[4];  ///< K'
  Pack w[3];  ///< W: xx, xy, yy

  template <Division How>
  // NOLINTNEXTLINE(readability-function-*): of one formula
  EPAFI_INLINE void evaluate(const KernelConstants& c, const Pack& dx, const Pack& dy,
                             const Pack& tx, const Pack& ty, const Pack& /*radius*/,
                             const double* source) {
    const double sx = source[2];
    const double sy = source[3];
    const Pack square = dx * dx + dy * dy;
    Pack inverse;
    reciprocal<How>(square, inverse);
    Pack log;
    logarithm(square, log);
    // d d'/r² = (I + [c2, s2; s2, -c2]) / 2
    const Pack c2 = (dx * dx - dy * dy) * inverse;
    const Pack s2 = 2.0 * dx * dy * inverse;
    const Pack half = 0.5 * c.a * log;
    v[0] = half - 0.5 * c.b * (1.0 + c2);
    v[1] = -0.5 * c.b * s2;
    v[2] = half - 0.5 * c.b * (1.0 - c2);
    // n = (τ_y, -τ_x)
    const Pack scaled = c.k * inverse;
    const Pack flowY = (dx * sy - dy * sx) * scaled;  // k (d·n_y)/r²
    const Pack skewY = c.turn * (dx * sx + dy * sy) * scaled;
    k[0] = (c.turn + 1.0 + c2) * flowY;
    k[1] = s2 * flowY - skewY;
    k[2] = s2 * flowY + skewY;
    k[3] = (c.turn + 1.0 - c2) * flowY;
    const Pack flowX = (dy * tx - dx * ty) * scaled;  // -k (d·n_x)/r²
    const Pack skewX = c.turn * (dx * tx + dy * ty) * scaled;
    t[0] = (c.turn + 1.0 + c2) * flowX;
    t[1] = s2 * flowX - skewX;
    t[2] = s2 * flowX + skewX;
    t[3] = (c.turn + 1.0 - c2) * flowX;
    const Pack real = tx * sx - ty * sy;  // of τ_x τ_y
    const Pack imag = tx * sy + ty * sx;
    const Pack plain = real * c2 + imag * s2;
    const Pack alpha = tx * sx + ty * sy - plain;
    const Pack beta = imag * c2 - real * s2;
    const Pack hyper = c.d * inverse;
    const Pack turned = c2 * alpha - s2 * beta;
    w[0] = hyper * (turned - plain);
    w[1] = hyper * (c2 * beta + s2 * alpha);
    w[2] = -hyper * (turned + plain);
  }
};

}  // namespace epafi::bem
