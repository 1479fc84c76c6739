#pragma once

#include "bem/base/Material.hpp"
#include "bem/base/Vec2.hpp"
#include "bem/simd/ComplexPack.hpp"

// Kelvin's kernels and their derivatives in complex numbers, w = x - y, N and τ = iN unit normal
// and tangent (PointKernels: V, K, K' and W in real numbers at eight pairs of points):
//                                                                [doc/theory/operators.md]
//
//   V f = ∫ -A log|w| f + B (f + conj(f) w/conj(w))/2 ds
//   K v = μ ∫ 2B Re(conj(N_y) v)/conj(w) + A N_y v/w + B conj(N_y v) w/conj(w)² ds
//   K'f = -μ ∫ 2B Re(f/w) N_x + conj(N_x) (A f/conj(w) + B conj(f) w/conj(w)²) ds
//   W v = D ∫ Re(τ_x/w) v' - (τ_x/conj(w) - conj(τ_x) w/conj(w)²) conj(v')/2 ds

namespace epafi::bem {

/// Integrals of a complex density g with the kernels at a point:
///
///   overW = ∫ g ds/w,  overConj = ∫ g ds/conj(w),  cubic = ∫ conj(g) w/conj(w)² ds
template <class Number>
struct SumsOf {
  Number overW{};
  Number overConj{};
  Number cubic{};

  void add(const SumsOf& other) {
    overW += other.overW;
    overConj += other.overConj;
    cubic += other.cubic;
  }
};
using SourceSums = SumsOf<Complex>;

template <class Number>
EPAFI_INLINE SumsOf<Number> operator+(const SumsOf<Number>& f, const SumsOf<Number>& g) {
  return {f.overW + g.overW, f.overConj + g.overConj, f.cubic + g.cubic};
}

/// Sums of the density g f from those of f, g a constant.
template <class Number>
EPAFI_INLINE SumsOf<Number> operator*(const Complex& g, const SumsOf<Number>& f) {
  return {g * f.overW, g * f.overConj, std::conj(g) * f.cubic};
}

// Number: Complex, or a ComplexPack of targets.

/// V f from ∫ f log|w| ds, ∫ f ds and ∫ conj(f) w/conj(w) ds.
template <class Number>
EPAFI_INLINE Number singleLayer(const Lame& lame, const Number& log, const Number& whole,
                                const Number& phase) {
  return -lame.a * log + 0.5 * lame.b * (whole + phase);
}

/// K v from the sums of N_y v and from those of the real Re(conj(N_y) v).
template <class Number>
EPAFI_INLINE Number doubleLayer(const Lame& lame, const SumsOf<Number>& normalTimesV,
                                const SumsOf<Number>& normalPart) {
  return lame.mu * (2 * lame.b * normalPart.overConj + lame.a * normalTimesV.overW +
                    lame.b * normalTimesV.cubic);
}

/// K' f on a line with unit normal N_x.
template <class Number>
EPAFI_INLINE Number adjointDoubleLayer(const Lame& lame, const Number& normal,
                                       const SumsOf<Number>& f) {
  return -2 * lame.mu * lame.b * (real(f.overW) * normal) -
         lame.mu * (conj(normal) * (lame.a * f.overConj + lame.b * f.cubic));
}

/// ∫ Re(τ/w) g ds
template <class Number>
EPAFI_INLINE Number alongTangent(const Number& tangent, const SumsOf<Number>& g) {
  return 0.5 * (tangent * g.overW + conj(tangent) * g.overConj);
}

/// ∫ conj(g) (τ/conj(w) - conj(τ) w/conj(w)²) ds
template <class Number>
EPAFI_INLINE Number turned(const Number& tangent, const SumsOf<Number>& g) {
  return tangent * conj(g.overW) - conj(tangent) * g.cubic;
}

/// W v at a point with unit normal N, from the sums of v' = dv/ds.
template <class Number>
EPAFI_INLINE Number hypersingular(const Lame& lame, const Number& normal,
                                  const SumsOf<Number>& slope) {
  const Number tangent = Complex(0, 1) * normal;
  return lame.d * (alongTangent(tangent, slope) - 0.5 * turned(tangent, slope));
}

/// d/ds V f along the tangent τ = iN.
template <class Number>
EPAFI_INLINE Number singleLayerSlope(const Lame& lame, const Number& normal,
                                     const SumsOf<Number>& f) {
  const Number tangent = Complex(0, 1) * normal;
  return -lame.a * alongTangent(tangent, f) + 0.5 * lame.b * turned(tangent, f);
}

/// d/ds K v from the sums of v'; by parts, valid on a closed boundary.
template <class Number>
EPAFI_INLINE Number doubleLayerSlope(const Lame& lame, const Number& normal,
                                     const SumsOf<Number>& slope) {
  const Number tangent = Complex(0, 1) * normal;
  return Complex(0, lame.mu) *
         (lame.b * (conj(tangent) * slope.overConj) - lame.a * (tangent * slope.overW) -
          lame.b * turned(tangent, slope));
}

/// Sums of a density ψ and of a displacement's derivative u'.
template <class Number>
struct FieldSumsOf {
  SumsOf<Number> density;
  SumsOf<Number> slope;

  void add(const FieldSumsOf& other) {
    density.add(other.density);
    slope.add(other.slope);
  }
};
using FieldSums = FieldSumsOf<Complex>;

/// K' ψ + W u.
template <class Number>
EPAFI_INLINE Number traction(const Lame& lame, const Number& normal,
                             const FieldSumsOf<Number>& sums) {
  return adjointDoubleLayer(lame, normal, sums.density) +
         hypersingular(lame, normal, sums.slope);
}

/// d/ds (V ψ - K u).
template <class Number>
EPAFI_INLINE Number mismatchSlope(const Lame& lame, const Number& normal,
                                  const FieldSumsOf<Number>& sums) {
  return singleLayerSlope(lame, normal, sums.density) -
         doubleLayerSlope(lame, normal, sums.slope);
}

// Blocks of V and K from double integrals of two scalar functions P and Q: log = ∫∫ P Q log|w|,
// phase = ∫∫ P Q w/conj(w), whole = ∫∫ P Q.  Number: double and Complex, or packs of pairs.

/// A 2 x 2 block of a Galerkin matrix by columns: both components of a test function,
/// then of a trial function.
template <class Number>
struct KernelBlock {
  Number xx;
  Number yx;
  Number xy;
  Number yy;
};

/// isotropic (-log|w| I) + radial d d'/r²: V for A and B; for D and D V*, whose functions are
/// derivatives by arc length.
/// d d'/r² = (I + [Re, Im; Im, -Re] of w/conj(w)) / 2.
template <class Number, class Phase>
EPAFI_INLINE KernelBlock<Number> singleLayerBlock(double isotropic, double radial,
                                                  const Number& log, const Phase& phase,
                                                  double whole) {
  const Number ofLog = isotropic * log;
  const Number xy = 0.5 * radial * imag(phase);
  return {0.5 * radial * (whole + real(phase)) - ofLog, xy, xy,
          0.5 * radial * (whole - real(phase)) - ofLog};
}

/// Block of K.  `log` and `phase` with the derivative of the trial function v; `laplace`: its
/// Laplace double layer ∫∫ P v (w·n_y)/|w|²:
///
///   K v = K_Δ v - X M v,  M v = (v₂', -v₁'),  X = 2μ V - V_Δ,
///
/// V_Δ and K_Δ Laplace's potentials.  The constant part of X is omitted, since ∫ v' = 0 over a
/// loop; 2μA - 1/2π = μ (A - B) = 2 μ (1-2ν) B avoids cancellation as ν -> 1/2.
template <class Number, class Phase>
EPAFI_INLINE KernelBlock<Number> doubleLayerBlock(const Lame& lame, const Number& log,
                                                  const Phase& phase,
                                                  const Number& laplace) {
  const double ofPhase = lame.mu * lame.b;
  const Number re = ofPhase * real(phase);
  const Number im = ofPhase * imag(phase);
  const Number ofLog = (2 * ofPhase * (1 - 2 * lame.nu)) * log;
  const Number l = lame.mu * (lame.a + lame.b) * laplace;  // 1/2π
  return {im + l, -re - ofLog, ofLog - re, l - im};
}

/// Blocks from double integrals, see TileBlocks.
struct KelvinMoments {
  static constexpr int components = 2;
  Lame lame;

  template <class Number, class Phase>
  EPAFI_INLINE KernelBlock<Number> singleLayer(const Number& log, const Phase& phase,
                                               double whole) const {
    return singleLayerBlock(lame.a, lame.b, log, phase, whole);
  }
  template <class Number, class Phase>
  EPAFI_INLINE KernelBlock<Number> slopes(const Number& log, const Phase& phase,
                                          double whole) const {
    return singleLayerBlock(lame.d, lame.d, log, phase, whole);
  }
  template <class Number, class Phase>
  EPAFI_INLINE KernelBlock<Number> doubleLayer(const Number& log, const Phase& phase,
                                               const Number& laplace) const {
    return doubleLayerBlock(lame, log, phase, laplace);
  }
  /// p·(-log r I + c d d'/r²) q; in complex numbers
  /// p·(d d'/r²) q = ½ Re(conj(p) q + conj(p) conj(q) w/conj(w)).
  double energy(const Complex& p, const Complex& q, double log, const Complex& phase,
                double whole, bool isSlope) const {
    const double product = std::real(std::conj(p) * q);
    const double turned = std::real(std::conj(p) * std::conj(q) * phase);
    return -(isSlope ? lame.d : lame.a) * log * product +
           0.5 * (isSlope ? lame.d : lame.b) * (whole * product + turned);
  }
};

}  // namespace epafi::bem
