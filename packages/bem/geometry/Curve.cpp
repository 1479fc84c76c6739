#include "bem/geometry/Curve.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::bem {

double distanceAlong(Position a, Position b) {
  return a.fromStart + b.fromStart < a.toEnd + b.toEnd ? b.fromStart - a.fromStart
                                                       : a.toEnd - b.toEnd;
}

namespace {

Position midpoint(Position a, Position b) {
  return {0.5 * (a.fromStart + b.fromStart), 0.5 * (a.toEnd + b.toEnd)};
}

template <class Number>
Number sinc(Number s) {
  return s == Number(0) ? Number(1) : std::sin(s) / s;
}

Vec2 turned(Vec2 v, double angle) {
  return std::cos(angle) * v + std::sin(angle) * turnLeft(v);
}

/// log(1 + u), accurate for small u; finite at -1, an arc's centre, where rounding decides.
Complex logOf1Plus(Complex u) {
  constexpr double rounding = 1e-17;
  const double square = 2 * u.real() + std::norm(u);
  return {std::norm(u) < 0.25 ? 0.5 * std::log1p(square)
                              : std::log(std::max(std::abs(1.0 + u), rounding)),
          std::atan2(u.imag(), 1 + u.real())};
}

/// A bulge far below rounding is none: curvatures and their reciprocals shall stay finite.
double halfAngle(double bulge) {
  constexpr double flat = 1e-20;
  return std::abs(bulge) < flat ? 0 : 2 * std::atan(bulge);
}

}  // namespace

Curve::Curve(Vec2 from, Vec2 to, Vec2 chord, double bulge)
    : from_(from), to_(to), alpha_(halfAngle(bulge)) {
  const double length = norm(chord);
  frame_.tangent = (1 / length) * chord;
  frame_.normal = turnRight(frame_.tangent);
  half_ = 0.5 * length / sinc(alpha_);
  frame_.middle = point(0.0);
}

// The ends of short curves differ by few digits, which do not tell the direction.
Curve Curve::moved(Vec2 shift) const {
  Curve result = *this;
  for (Vec2* place : {&result.from_, &result.to_, &result.frame_.middle})
    *place = *place + shift;
  return result;
}

Curve Curve::part(Position start, Position end) const {
  Curve result;
  const Position middle = midpoint(start, end);
  result.from_ = point(start);
  result.to_ = point(end);
  result.frame_.middle = point(middle);
  result.frame_.tangent = tangent(parameter(middle));
  result.frame_.normal = turnRight(result.frame_.tangent);
  result.half_ = 0.5 * distanceAlong(start, end);
  result.alpha_ = curvature() * result.half_;
  return result;
}

double Curve::parameter(Position place) const {
  return place.fromStart < place.toEnd ? place.fromStart / half_ - 1
                                       : 1 - place.toEnd / half_;
}

Vec2 Curve::turnedTangent(double t) const { return turned(frame_.tangent, alpha_ * t); }

Vec2 Curve::chordOfArc(double t, double distance) const {
  const double s = 0.5 * distance / half_;
  return distance * sinc(alpha_ * s) * tangent(t + s);
}

Vec2 Curve::chord(Position a, double offsetA, Position b, double offsetB) const {
  return chord(parameter(a) + offsetA / half_, distanceAlong(a, b) + (offsetB - offsetA));
}

Vec2 Curve::centroid() const {
  const double depth = isStraight() ? 0 : half_ * (1 - sinc(alpha_)) / alpha_;
  return frame_.middle - depth * frame_.normal;
}

Vec2 Curve::point(double t) const {
  return point(Position{half_ * (1 + t), half_ * (1 - t)});
}

Vec2 Curve::point(Position place, double offset) const {
  return place.fromStart < place.toEnd ? from_ + fromStart(place.fromStart + offset)
                                       : to_ + fromEnd(offset - place.toEnd);
}

double Curve::distance(Vec2 x) const {
  const RelativeTarget z = seen(x);
  if (z.zPlus1.real() < 0 || z.zMinus1.real() > 0)
    return std::min(norm(x - from_), norm(x - to_));
  // the distance from the centre is e^{αb} radii
  return half_ * std::abs(isStraight() ? z.b() : std::expm1(alpha_ * z.b()) / alpha_);
}

// (x - c)/(y(±1) - c) = 1 + κ w/n with w the offset from that end, c the centre
RelativeTarget Curve::seen(Vec2 toStart, Vec2 toEnd) const {
  const auto local = [this](Vec2 offset, double end) -> Complex {
    if (isStraight())
      return Complex(dot(offset, frame_.tangent), dot(offset, frame_.normal)) / half_;
    const Complex u = curvature() * asComplex(offset) * std::conj(asComplex(normal(end)));
    return std::conj(Complex(0, -1) * logOf1Plus(u) / alpha_);
  };
  if (dot(toEnd, toEnd) < dot(toStart, toStart)) {
    const Complex minus = local(toEnd, 1);
    return {minus + 1.0, minus, minus + 2.0};
  }
  const Complex plus = local(toStart, -1);
  return {plus - 1.0, plus - 2.0, plus};
}

Complex Curve::factor(const RelativeTarget& x, double t) const {
  const Complex tangent = half_ * asComplex(frame_.tangent);
  if (isStraight())
    return tangent;
  const Complex place = std::conj(x.z);
  return tangent * std::exp(Complex(0, 0.5 * alpha_) * (place + t)) *
         sinc(0.5 * alpha_ * (place - t));
}

bool joinSmoothly(const Curve& arriving, const Curve& leaving) {
  constexpr double rounding = 1e-12;
  const Vec2 before = arriving.tangent(1);
  const Vec2 behind = leaving.tangent(-1);
  const bool straight = arriving.isStraight() && leaving.isStraight();
  return std::abs(cross(before, behind)) <= (straight ? rounding : smoothAngle) &&
         dot(before, behind) > 0;
}

}  // namespace epafi::bem
