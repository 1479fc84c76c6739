#pragma once

#include <cmath>

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
/// a turned by +90 degrees; the tangent that belongs to the normal a.
inline Vec2 turnLeft(Vec2 a) { return {-a.y, a.x}; }
/// a turned by -90 degrees; the outward normal that belongs to the tangent a.
inline Vec2 turnRight(Vec2 a) { return {a.y, -a.x}; }

}  // namespace epafi::bem
