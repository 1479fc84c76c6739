#pragma once

#include "bem/base/Vec2.hpp"

#include <stdexcept>

namespace epafi::bem {

/// A place on a curve by arc length, accurate near both of its ends.
struct Position {
  double fromStart = 0;
  double toEnd = 0;
};

/// fromStart of b minus fromStart of a, from whichever end loses fewer digits.
double distanceAlong(Position a, Position b);

/// A target x seen from a curve: the number z = conj(t₀), t₀ the complex parameter with
/// y(t₀) = x.  From a segment z = a + ib, a = 2(x-m)·τ/h, b = 2(x-m)·n/h.  Both z-1 and
/// z+1 are kept, since one of them is tiny near an end.  b < 0 on the body's side; b = 0
/// exactly on the curve itself.
struct RelativeTarget {
  Complex zMinus1;
  Complex zPlus1;
  double b() const { return zMinus1.imag(); }
  /// z itself, from the offset that loses no digits.
  Complex z() const {
    return std::norm(zMinus1) < std::norm(zPlus1) ? 1.0 + zMinus1 : zPlus1 - 1.0;
  }
};

/// A segment or a circular arc y(t), -1 <= t <= 1, at constant speed |dy/dt| = half; the
/// body lies to its left.
///
/// Angles turn, points move: y(t₁) - y(t₀) is the arc's tangent half way times the length
/// of its chord, so nothing is lost as an arc becomes a segment, and no centre is needed.
/// A target x has the complex place t₀ (see RelativeTarget), the branch nearest to [-1,
/// 1] of y(t₀) = x, and                                         [doc/theory/operators.md]
///
///   w = x - y(t) = (t₀ - t) g(t),  g = half τ(0) e^{iα(t₀+t)/2} sinc(α(t₀-t)/2),
///
/// 2α the angle by which the curve turns, sinc(s) = sin(s)/s.
class Curve {
 public:
  /// Where the curve is and goes at t = 0.
  struct Frame {
    Vec2 middle;
    Vec2 tangent;
    Vec2 normal;  ///< the tangent turned right: outward
  };

  Curve() = default;

  /// From one point to another; bulge = tan(angle/4), 0: straight, > 0: turning left, to
  /// the right of its chord (1: half a circle).
  Curve(Vec2 from, Vec2 to, double bulge = 0) : Curve(from, to, to - from, bulge) {}
  /// The same with a chord that is known better than from the rounded ends.
  Curve(Vec2 from, Vec2 to, Vec2 chord, double bulge);

  /// The same elsewhere.
  Curve moved(Vec2 shift) const;
  /// What lies between two places.
  Curve part(Position start, Position end) const;

  Vec2 from() const { return from_; }
  Vec2 to() const { return to_; }
  double half() const { return half_; }
  double length() const { return 2 * half_; }
  /// By which it turns, to the left; 0: a segment.
  double angle() const { return 2 * alpha_; }
  double curvature() const { return alpha_ == 0 ? 0 : alpha_ / half_; }
  bool isStraight() const { return alpha_ == 0; }

  const Frame& frame() const { return frame_; }
  /// The frame of a segment, which is the same everywhere: for what knows no arcs yet.
  /// \throws std::logic_error of an arc.
  const Frame& segment() const {
    if (!isStraight())
      throw std::logic_error("an arc is taken for a segment");
    return frame_;
  }

  Vec2 tangent(double t) const;
  Vec2 normal(double t) const { return turnRight(tangent(t)); }
  /// y(t), from the nearer end.
  Vec2 point(double t) const;
  /// The point `offset` along the curve from a place.
  Vec2 point(Position place, double offset = 0) const;
  /// From the start to the point this far along, and from the end to the one this far
  /// ahead of it (before it, if negative).
  Vec2 fromStart(double distance) const { return chord(-1, distance); }
  Vec2 fromEnd(double distance) const { return chord(1, distance); }
  /// From y(0) to y(t).
  Vec2 fromMiddle(double t) const { return chord(0, half_ * t); }
  /// From one place and offset to another.
  Vec2 chord(Position a, double offsetA, Position b, double offsetB) const;

  double distance(Vec2 x) const;
  /// Of its mass: ∫ y ds / length.
  Vec2 centroid() const;
  bool contains(Vec2 x, double tolerance) const { return distance(x) <= tolerance; }

  RelativeTarget seen(Vec2 x) const { return seen(x - from_, x - to_); }
  /// By its offsets from both ends.
  RelativeTarget seen(Vec2 toStart, Vec2 toEnd) const;
  /// g(t), so that x - y(t) = conj(z - t) g(t).
  Complex factor(const RelativeTarget& x, double t) const;

 private:
  double parameter(Position place) const;
  Vec2 chord(double t, double distance) const;

  Vec2 from_;
  Vec2 to_;
  Frame frame_;
  double half_ = 0;
  double alpha_ = 0;
};

/// Tangents that differ by less meet smoothly where one of the curves is an arc: 1 degree.
constexpr double smoothAngle = 0.017453292519943295;

/// Does one curve go on as the other without a corner?  Segments do on one line only.
bool joinSmoothly(const Curve& arriving, const Curve& leaving);

}  // namespace epafi::bem
