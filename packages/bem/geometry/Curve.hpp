#pragma once

#include "bem/base/Vec2.hpp"

#include <stdexcept>

namespace epafi::bem {

/// A place on a curve by arc length, accurate near both of its ends.
struct Position {
  double fromStart = 0;
  double toEnd = 0;
};

/// Arc length from a to b, computed from the end with less cancellation.
double distanceAlong(Position a, Position b);

/// A target x relative to a curve: z = conj(t₀), t₀ the complex parameter with y(t₀) = x.  For
/// a segment z = a + ib, a = 2(x-m)·τ/h, b = 2(x-m)·n/h.  z-1 and z+1 are stored, too, since one
/// of them is small near an end.  b < 0 on the side of the body; b = 0 exactly on the curve.
/// Number: Complex, or a pack of eight targets.
template <class Number>
struct TargetOf {
  Number z{};
  Number zMinus1{};
  Number zPlus1{};
  double b() const { return imag(z); }
};
using RelativeTarget = TargetOf<Complex>;

/// From z - 1 and z + 1, of which the smaller one is accurate.
inline RelativeTarget targetAt(const Complex& minus1, const Complex& plus1) {
  return std::norm(minus1) < std::norm(plus1)
             ? RelativeTarget{1.0 + minus1, minus1, minus1 + 2.0}
             : RelativeTarget{plus1 - 1.0, plus1 - 2.0, plus1};
}

/// A segment or a circular arc y(t), -1 <= t <= 1, at constant speed |dy/dt| = half; the
/// body lies to its left.
///
/// y(t₁) - y(t₀) is the tangent at (t₀+t₁)/2 times the length of the chord; there is no
/// cancellation as an arc tends to a segment, and no centre is needed.  A target x has the
/// complex parameter t₀ (see RelativeTarget), the solution of y(t₀) = x nearest to [-1, 1],
/// and                                                          [doc/theory/operators.md]
///
///   w = x - y(t) = (t₀ - t) g(t),  g = half τ(0) e^{iα(t₀+t)/2} sinc(α(t₀-t)/2),
///
/// 2α the angle by which the curve turns, sinc(s) = sin(s)/s.
class Curve {
 public:
  /// Point, tangent and normal at t = 0.
  struct Frame {
    Vec2 middle;
    Vec2 tangent;
    Vec2 normal;  ///< the tangent turned right: outward
  };

  Curve() = default;

  /// Curve between two points.  bulge = tan(angle/4): 0 a segment; > 0 an arc that turns left
  /// and lies to the right of its chord; 1 half a circle.
  Curve(Vec2 from, Vec2 to, double bulge = 0) : Curve(from, to, to - from, bulge) {}
  /// \param chord to - from, more accurate than the difference of the rounded ends
  Curve(Vec2 from, Vec2 to, Vec2 chord, double bulge);

  /// The curve shifted.
  Curve moved(Vec2 shift) const;
  /// The part between two positions.
  Curve part(Position start, Position end) const;

  Vec2 from() const { return from_; }
  Vec2 to() const { return to_; }
  double half() const { return half_; }
  double length() const { return 2 * half_; }
  /// Angle [rad] by which the curve turns left; 0: a segment.
  double angle() const { return 2 * alpha_; }
  double curvature() const { return alpha_ == 0 ? 0 : alpha_ / half_; }
  bool isStraight() const { return alpha_ == 0; }
  /// Of an arc.
  Vec2 centre() const { return frame_.middle - (1 / curvature()) * frame_.normal; }
  /// Gauss points, in addition to those for polynomials, for normals and products of two normals.
  int pointsOfTurning() const { return isStraight() ? 0 : 14; }

  const Frame& frame() const { return frame_; }
  /// The constant frame of a segment, for code without support of arcs.
  /// \throws std::logic_error for an arc
  const Frame& segment() const {
    if (!isStraight())
      throw std::logic_error("an arc is taken for a segment");
    return frame_;
  }

  Vec2 tangent(double t) const {
    return isStraight() ? frame_.tangent : turnedTangent(t);
  }
  Vec2 normal(double t) const { return turnRight(tangent(t)); }
  /// y(t), computed from the nearer end.
  Vec2 point(double t) const;
  /// The point at arc length `offset` from a position.
  Vec2 point(Position place, double offset = 0) const;
  /// Vector from the start, or from the end, to the point at this arc length from it (< 0: before
  /// it).
  Vec2 fromStart(double distance) const { return chord(-1, distance); }
  Vec2 fromEnd(double distance) const { return chord(1, distance); }
  /// y(t) - y(0)
  Vec2 fromMiddle(double t) const { return chord(0, half_ * t); }
  /// Vector from the point at offsetA from a to the point at offsetB from b.
  Vec2 chord(Position a, double offsetA, Position b, double offsetB) const;

  double distance(Vec2 x) const;
  /// ∫ y ds / length
  Vec2 centroid() const;
  bool contains(Vec2 x, double tolerance) const { return distance(x) <= tolerance; }

  RelativeTarget seen(Vec2 x) const { return seen(x - from_, x - to_); }
  /// \param toStart, toEnd x - from() and x - to()
  RelativeTarget seen(Vec2 toStart, Vec2 toEnd) const;
  /// g(t), so that x - y(t) = conj(z - t) g(t).
  Complex factor(const RelativeTarget& x, double t) const;

 private:
  double parameter(Position place) const;
  Vec2 turnedTangent(double t) const;
  Vec2 chordOfArc(double t, double distance) const;
  // A chord has the direction of the tangent half way.
  Vec2 chord(double t, double distance) const {
    return isStraight() ? distance * frame_.tangent : chordOfArc(t, distance);
  }

  Vec2 from_;
  Vec2 to_;
  Frame frame_;
  double half_ = 0;
  double alpha_ = 0;
};

/// Largest angle between tangents at a smooth joint with an arc: 1 degree.
constexpr double smoothAngle = 0.017453292519943295;

/// Is the joint of two curves smooth?  Two segments must be on one line.
bool joinSmoothly(const Curve& arriving, const Curve& leaving);

}  // namespace epafi::bem
