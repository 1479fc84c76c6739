#pragma once

#include <cstddef>

// Functions that the variants of a kernel share must be inlined: the linker could choose an
// out-of-line copy compiled for AVX-512 on an older processor.
#define EPAFI_INLINE inline __attribute__((always_inline))

namespace epafi::bem {

/// Number of doubles in a Pack.
constexpr int lanes = 8;

/// Eight doubles, in as many registers as the processor needs.  Passed by reference only:
/// the ABI of vectors wider than the baseline's registers depends on the instruction set, and so
/// does their alignment: a struct of Packs that outlives a kernel is alignas(64).
using Pack = double __attribute__((vector_size(8 * lanes)));

/// Storage of a Pack in containers.
struct alignas(64) AlignedLane {
  double lane[lanes];
};

/// Loads, stores, adds to memory.  \pre p is aligned to 64 bytes
EPAFI_INLINE const Pack& load(const double* p) {
  return *reinterpret_cast<const Pack*>(p);
}
EPAFI_INLINE void store(double* p, const Pack& v) { *reinterpret_cast<Pack*>(p) = v; }
EPAFI_INLINE void add(double* p, const Pack& v) { *reinterpret_cast<Pack*>(p) += v; }

/// Writes x₀, y₀, x₁, y₁, ..., x₇, y₇.
EPAFI_INLINE void interleave(const Pack& x, const Pack& y, double* to) {
  const Pack first = __builtin_shufflevector(x, y, 0, 8, 1, 9, 2, 10, 3, 11);
  const Pack second = __builtin_shufflevector(x, y, 4, 12, 5, 13, 6, 14, 7, 15);
  __builtin_memcpy(to, &first, sizeof first);
  __builtin_memcpy(to + lanes, &second, sizeof second);
}

/// result = (0, x₀, ..., x₆)
EPAFI_INLINE void shiftUp(const Pack& x, Pack& result) {
  const Pack zero{};
  result = __builtin_shufflevector(x, zero, 8, 0, 1, 2, 3, 4, 5, 6);
}

/// Exact: the division instruction.  Fused: fused multiply-adds, faster unless the
/// divider runs beside the multipliers.
enum class Division { Exact, Fused };

/// 1/x of normal numbers, relative error 4e-16.  Fused: an initial value from the bits,
/// relative error at most 12 %, then two iterations of third order and one of second
/// (Newton).
template <Division How>
EPAFI_INLINE void reciprocal(const Pack& x, Pack& result) {
  if (How == Division::Exact) {
    result = 1.0 / x;
    return;
  }
  using Bits = unsigned long long __attribute__((vector_size(8 * lanes)));
  constexpr unsigned long long twiceOne = 0x7fde623822fc16e6;
  const Bits guess = twiceOne - reinterpret_cast<Bits>(x);
  Pack y = reinterpret_cast<Pack>(guess);
  for (int step = 0; step < 2; ++step) {
    const Pack error = 1.0 - x * y;
    y += y * (error + error * error);
  }
  result = y + y * (1.0 - x * y);
}

/// log x of positive normal numbers, error 4e-16 max(1, |log x|): x = 2^e m, m in [1/√2,
/// √2], log m = 2 artanh s, s = (m-1)/(m+1), |s| <= 0.172, by the Taylor series.
EPAFI_INLINE void logarithm(const Pack& x, Pack& result) {
  using Bits = unsigned long long __attribute__((vector_size(8 * lanes)));
  constexpr unsigned long long rootHalf = 0x3fe6a09e667f3bcd;
  constexpr unsigned long long bias = 1023;
  const Bits bits = reinterpret_cast<Bits>(x);
  const Bits biased = (bits - rootHalf + (bias << 52)) >> 52;
  const Bits scaled = bits - ((biased - bias) << 52);
  // 2^52 with an integer k < 2^52 in its last bits is the double 2^52 + k
  const Bits shifted = biased | 0x4330000000000000ull;
  const Pack exponent = reinterpret_cast<Pack>(shifted) - (4503599627370496.0 + 1023.0);
  const Pack f = reinterpret_cast<Pack>(scaled) - 1.0;
  const Pack s = f / (f + 2.0);
  const Pack z = s * s;
  Pack series = z * (1.0 / 21) + 1.0 / 19;
#pragma GCC unroll 8
  for (int k = 17; k >= 3; k -= 2)
    series = series * z + 1.0 / k;
  result = exponent * 0.69314718055994530942 + 2.0 * s * (1.0 + z * series);
}

/// sin(x)/x and cos x for |x| <= π/4, by their series.
EPAFI_INLINE void sineCosine(const Pack& x, Pack& sinc, Pack& cosine) {
  const Pack z = -x * x;
  sinc = z * (1.0 / (18 * 19)) + 1.0;
  cosine = z * (1.0 / (17 * 18)) + 1.0;
#pragma GCC unroll 8
  for (int k = 8; k >= 1; --k) {
    sinc = sinc * z * (1.0 / (2 * k * (2 * k + 1))) + 1.0;
    cosine = cosine * z * (1.0 / ((2 * k - 1) * 2 * k)) + 1.0;
  }
}

/// √x, correctly rounded.  \pre x >= 0
EPAFI_INLINE void squareRoot(const Pack& x, Pack& result) {
  for (int lane = 0; lane < lanes; ++lane)
    result[lane] = __builtin_sqrt(x[lane]);
}

/// atan2(y, x) in [-π, π], error 4e-16 max(|angle|, 1e-300).  Rotations by multiples of π/8
/// reduce the angle below π/16 (tan = 0.199); then the Taylor series of arctan.
/// \pre (x, y) is not zero
EPAFI_INLINE void angle(const Pack& y, const Pack& x, Pack& result) {
  const Pack zero{};
  const Pack sizeX = x < 0.0 ? -x : x;
  const Pack sizeY = y < 0.0 ? -y : y;
  const auto isSteep = sizeY > sizeX;
  Pack along = isSteep ? sizeY : sizeX;
  Pack across = isSteep ? sizeX : sizeY;
  Pack turned{};
  // rotates by π/4, then by π/8, if the remaining angle is above half of that
  constexpr double pi = 3.14159265358979323846;
  constexpr double tangents[2] = {1, 0.41421356237309504880};
  constexpr double halfway[2] = {0.41421356237309504880, 0.19891236737965800691};
  double step = pi / 4;
  for (int k = 0; k < 2; ++k) {
    const auto isAbove = (across < 0.0 ? -across : across) > halfway[k] * along;
    const auto isNegative = across < 0.0;
    const Pack sign = isAbove ? (isNegative ? zero - 1.0 : zero + 1.0) : zero;
    const Pack tangent = sign * tangents[k];
    turned += sign * step;
    const Pack next = across - tangent * along;
    along += tangent * across;
    across = next;
    step *= 0.5;
  }
  const Pack t = across / along;
  const Pack z = -t * t;
  Pack series = z * (1.0 / 23) + 1.0 / 21;
#pragma GCC unroll 10
  for (int k = 19; k >= 3; k -= 2)
    series = series * z + 1.0 / k;
  Pack a = turned + (t + t * (z * series));
  a = isSteep ? pi / 2 - a : a;
  a = x < 0.0 ? pi - a : a;
  result = y < 0.0 ? -a : a;
}

}  // namespace epafi::bem
