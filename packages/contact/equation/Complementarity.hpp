#pragma once

namespace epafi::contact {

/// Complementarity function F(λ, y, s) of one coefficient: its value and one element of its
/// generalised gradient.
///
/// y = c r, c > 0: penetration (normal) or slip (tangential) as a stress; s >= 0: slip
/// bound. F = 0 is equivalent to
///
///   normal:       λ ≥ 0,  y ≤ 0,  λ y = 0
///   tangential:   |λ| ≤ s,  |λ| < s ⇒ y = 0,  λ = ± s ⇒ ± y ≥ 0
///
/// F is semismooth, nondecreasing in λ, nonincreasing in y; s = 0 gives λ = 0, s = ∞
/// gives y = 0.
struct Complementarity {
  double value;
  double multiplier;   ///< ∂F/∂λ >= 0
  double penetration;  ///< ∂F/∂y <= 0
  double bound;        ///< ∂F/∂s
};

/// λ - P(λ + y), P the projection onto [0, ∞) or [-s, s]; used by Equation.  Either ∂F/∂λ
/// or ∂F/∂y is zero, so that Newton's method is an active set method.
Complementarity projectedNormal(double multiplier, double penetration);
Complementarity projectedTangential(double multiplier, double slip, double bound);

/// By the Fischer-Burmeister function a + b - √(a² + b²).  F² is continuously
/// differentiable, unlike that of the projection; used by SmoothMerit.
Complementarity fischerNormal(double multiplier, double penetration);
Complementarity fischerTangential(double multiplier, double slip, double bound);

}  // namespace epafi::contact
