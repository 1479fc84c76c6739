#pragma once

#include "bem/simd/Pack.hpp"

namespace epafi::bem {

/// A function of a point x = (ρ, z), and its derivatives, for kernels of stresses inside solids of
/// revolution: RingFunctions take it in place of a Pack.
struct RingJet {
  Pack value;
  Pack r;  ///< ∂/∂ρ
  Pack z;
};

EPAFI_INLINE RingJet operator+(const RingJet& a, const RingJet& b) {
  return {a.value + b.value, a.r + b.r, a.z + b.z};
}
EPAFI_INLINE RingJet operator-(const RingJet& a, const RingJet& b) {
  return {a.value - b.value, a.r - b.r, a.z - b.z};
}
EPAFI_INLINE RingJet operator*(const RingJet& a, const RingJet& b) {
  return {a.value * b.value, a.value * b.r + a.r * b.value,
          a.value * b.z + a.z * b.value};
}
EPAFI_INLINE RingJet operator*(double s, const RingJet& a) {
  return {s * a.value, s * a.r, s * a.z};
}
EPAFI_INLINE RingJet operator*(const Pack& s, const RingJet& a) {
  return {s * a.value, s * a.r, s * a.z};
}

template <Division How>
EPAFI_INLINE void reciprocal(const RingJet& a, RingJet& result) {
  Pack inverse;
  reciprocal<How>(a.value, inverse);
  const Pack slope = -inverse * inverse;
  result = {inverse, slope * a.r, slope * a.z};
}

EPAFI_INLINE void squareRoot(const RingJet& a, RingJet& result) {
  Pack root;
  squareRoot(a.value, root);
  const Pack slope = 0.5 / root;
  result = {root, slope * a.r, slope * a.z};
}

}  // namespace epafi::bem
