#pragma once

#include <cmath>
#include <complex>

namespace epafi::bem {

/// A point or a vector of the plane.
struct Vec2 {
  double x = 0;
  double y = 0;
};

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
inline Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
inline bool operator==(Vec2 a, Vec2 b) { return a.x == b.x && a.y == b.y; }
inline bool operator!=(Vec2 a, Vec2 b) { return !(a == b); }

inline double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// a₁b₂ - a₂b₁: positive when b lies to the left of a.
inline double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline double norm(Vec2 a) { return std::hypot(a.x, a.y); }
/// Norm without protection against overflow, several times as fast.
inline double length(Vec2 a) { return std::sqrt(dot(a, a)); }
/// a turned by +90 degrees; the tangent that belongs to the normal a.
inline Vec2 turnLeft(Vec2 a) { return {-a.y, a.x}; }
/// a turned by -90 degrees; the outward normal that belongs to the tangent a.
inline Vec2 turnRight(Vec2 a) { return {a.y, -a.x}; }

using Complex = std::complex<double>;

/// A vector of the plane as a complex number, x + iy, and back.
inline Complex asComplex(Vec2 v) { return {v.x, v.y}; }
inline Vec2 asVector(Complex z) { return {z.real(), z.imag()}; }

}  // namespace epafi::bem
