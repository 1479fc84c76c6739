#include "bem/kernel/Elasticity.hpp"

namespace epafi::bem {

namespace {

constexpr Complex i(0, 1);

/// ∫ Re(τ/w) g ds
Complex alongTangent(Complex tangent, const SourceSums& g) {
  return 0.5 * (tangent * g.overW + std::conj(tangent) * g.overConj);
}

/// ∫ conj(g) (τ/conj(w) - conj(τ) w/conj(w)²) ds
Complex turned(Complex tangent, const SourceSums& g) {
  return tangent * std::conj(g.overW) - std::conj(tangent) * g.cubic;
}

}  // namespace

Complex singleLayer(const Lame& lame, Complex log, Complex whole, Complex phase) {
  return -lame.a * log + 0.5 * lame.b * (whole + phase);
}

Complex doubleLayer(const Lame& lame, const SourceSums& normalTimesV,
                    const SourceSums& normalPart) {
  return lame.mu * (2 * lame.b * normalPart.overConj + lame.a * normalTimesV.overW +
                    lame.b * normalTimesV.cubic);
}

Complex adjointDoubleLayer(const Lame& lame, Complex normal, const SourceSums& f) {
  return -2 * lame.mu * lame.b * f.overW.real() * normal -
         lame.mu * std::conj(normal) * (lame.a * f.overConj + lame.b * f.cubic);
}

Complex hypersingular(const Lame& lame, Complex normal, const SourceSums& slope) {
  const Complex tangent = i * normal;
  return lame.d * (alongTangent(tangent, slope) - 0.5 * turned(tangent, slope));
}

Complex singleLayerSlope(const Lame& lame, Complex normal, const SourceSums& f) {
  const Complex tangent = i * normal;
  return -lame.a * alongTangent(tangent, f) + 0.5 * lame.b * turned(tangent, f);
}

Complex doubleLayerSlope(const Lame& lame, Complex normal, const SourceSums& slope) {
  const Complex tangent = i * normal;
  return i * lame.mu *
         (lame.b * std::conj(tangent) * slope.overConj - lame.a * tangent * slope.overW -
          lame.b * turned(tangent, slope));
}

}  // namespace epafi::bem
