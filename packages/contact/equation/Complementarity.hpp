#pragma once

namespace epafi::contact {

/// The contact conditions of one coefficient as an equation  F(λ, y, s) = 0: its value, and one
/// element of its generalised gradient, a limit of gradients from nearby.
///
/// y = c r is the penetration (normal) or the slip (tangential) turned into a stress by a
/// positive factor c; s >= 0 is the slip bound.  F = 0 says
///
///   normal:       λ ≥ 0,  y ≤ 0,  λ y = 0
///   tangential:   |λ| ≤ s,  |λ| < s ⇒ y = 0,  λ = ± s ⇒ ± y ≥ 0
///
/// F is semismooth, grows with λ, falls with y; s = 0 is allowed and means λ = 0, s = ∞ means
/// y = 0.
struct Complementarity {
  double value;
  double multiplier;   ///< ∂F/∂λ >= 0
  double penetration;  ///< ∂F/∂y <= 0
  double bound;        ///< ∂F/∂s
};

/// λ - P(λ + y), P the projection onto [0, ∞) or [-s, s]: the equation.  Active sets: either ∂F/∂λ or
/// ∂F/∂y is zero, and where λ follows s, F does not depend on y.
Complementarity projectedNormal(double multiplier, double penetration);
Complementarity projectedTangential(double multiplier, double slip, double bound);

/// By Fischer and Burmeister's a + b - √(a² + b²).  F² is continuously differentiable, which that
/// of the projection is not: the merit function's, see SmoothMerit.
Complementarity fischerNormal(double multiplier, double penetration);
Complementarity fischerTangential(double multiplier, double slip, double bound);

}  // namespace epafi::contact
