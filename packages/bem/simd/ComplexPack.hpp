#pragma once

#include "bem/simd/Pack.hpp"

#include <complex>

namespace epafi::bem {

/// Eight complex numbers, with the operators that templates over std::complex<double> use.
struct alignas(64) ComplexPack {
  Pack re{};
  Pack im{};
};

EPAFI_INLINE const Pack& real(const ComplexPack& x) { return x.re; }
EPAFI_INLINE const Pack& imag(const ComplexPack& x) { return x.im; }
/// result = |x|²
EPAFI_INLINE void squareOf(const ComplexPack& x, Pack& result) {
  result = x.re * x.re + x.im * x.im;
}
EPAFI_INLINE ComplexPack conj(const ComplexPack& x) { return {x.re, -x.im}; }
EPAFI_INLINE ComplexPack operator+(const ComplexPack& x, const ComplexPack& y) {
  return {x.re + y.re, x.im + y.im};
}
EPAFI_INLINE ComplexPack operator-(const ComplexPack& x, const ComplexPack& y) {
  return {x.re - y.re, x.im - y.im};
}
EPAFI_INLINE ComplexPack operator*(double s, const ComplexPack& x) {
  return {s * x.re, s * x.im};
}
EPAFI_INLINE ComplexPack operator*(const Pack& s, const ComplexPack& x) {
  return {s * x.re, s * x.im};
}
EPAFI_INLINE ComplexPack operator*(const std::complex<double>& s, const ComplexPack& x) {
  return {s.real() * x.re - s.imag() * x.im, s.real() * x.im + s.imag() * x.re};
}
EPAFI_INLINE ComplexPack operator*(const ComplexPack& x, const ComplexPack& y) {
  return {x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re};
}

/// Storage of a ComplexPack in containers.
struct ComplexLanes {
  AlignedLane re;
  AlignedLane im;

  EPAFI_INLINE ComplexPack load() const {
    return {bem::load(re.lane), bem::load(im.lane)};
  }
  EPAFI_INLINE void store(const ComplexPack& x) {
    bem::store(re.lane, x.re);
    bem::store(im.lane, x.im);
  }
  EPAFI_INLINE std::complex<double> operator[](std::size_t lane) const {
    return {re.lane[lane], im.lane[lane]};
  }
  void set(int lane, const std::complex<double>& x) {
    re.lane[lane] = x.real();
    im.lane[lane] = x.imag();
  }
};

}  // namespace epafi::bem
