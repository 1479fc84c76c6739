#pragma once

#include "bem/base/Vec2.hpp"
#include "bem/simd/ComplexPack.hpp"

// Laplace's kernels, w = x - y, n and τ the unit normal and tangent:      [doc/theory/operators.md]
//
//   V q = -1/2π ∫ log|w| q ds,  K T = 1/2π ∫ (w·n_y)/|w|² T ds,  K' q = -1/2π ∫ (w·n_x)/|w|² q ds,
//   W T = -d/ds V (dT/ds);  for continuous functions with different supports
//   W T = -1/2π ∫ Re(τ_x τ_y/w²) T ds

namespace epafi::bem {

constexpr double overTwoPi = 0.15915494309189534;

/// A block of scalar functions.
template <class Number>
struct ScalarBlock {
  Number value;
};

/// Blocks from double integrals, see TileBlocks.
struct LaplaceMoments {
  static constexpr int components = 1;

  template <class Number, class Phase>
  EPAFI_INLINE ScalarBlock<Number> singleLayer(const Number& log, const Phase& /*phase*/,
                                               double /*whole*/) const {
    return {-overTwoPi * log};
  }
  template <class Number, class Phase>
  EPAFI_INLINE ScalarBlock<Number> slopes(const Number& log, const Phase& phase,
                                          double whole) const {
    return singleLayer(log, phase, whole);
  }
  template <class Number, class Phase>
  EPAFI_INLINE ScalarBlock<Number> doubleLayer(const Number& /*log*/,
                                               const Phase& /*phase*/,
                                               const Number& laplace) const {
    return {overTwoPi * laplace};
  }
  double energy(const Complex& p, const Complex& q, double log, const Complex& /*phase*/,
                double /*whole*/, bool /*isSlope*/) const {
    return -overTwoPi * log * p.real() * q.real();
  }
};

/// The kernels at pairs of points, see FarQuadrature.
struct LaplacePoints {
  static constexpr int components = 1;
  struct Constants {};

  Pack v[1];  ///< -V
  Pack k[1];
  Pack t[1];  ///< K'
  Pack w[1];

  template <Division How>
  EPAFI_INLINE void evaluate(const Constants& /*constants*/, const Pack& dx,
                             const Pack& dy, const Pack& tx, const Pack& ty,
                             const Pack& /*radius*/, const double* source) {
    const double sx = source[2];
    const double sy = source[3];
    const Pack square = dx * dx + dy * dy;
    Pack inverse;
    reciprocal<How>(square, inverse);
    Pack log;
    logarithm(square, log);
    v[0] = (0.5 * overTwoPi) * log;
    const Pack scaled = overTwoPi * inverse;
    k[0] = (dx * sy - dy * sx) * scaled;  // n = (τ_y, -τ_x)
    t[0] = (dy * tx - dx * ty) * scaled;
    // Re(τ_x τ_y conj(w)²)
    const Pack along =
        (tx * sx - ty * sy) * (dx * dx - dy * dy) + 2.0 * (tx * sy + ty * sx) * (dx * dy);
    w[0] = -scaled * (along * inverse);
  }
};

}  // namespace epafi::bem
