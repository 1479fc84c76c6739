#pragma once

#include "bem/base/Vec2.hpp"

#include <complex>

namespace epafi::bem {

using Complex = std::complex<double>;

/// A vector of the plane as a complex number, x + iy, and back.
inline Complex asComplex(Vec2 v) { return {v.x, v.y}; }
inline Vec2 asVector(Complex z) { return {z.real(), z.imag()}; }

}  // namespace epafi::bem
