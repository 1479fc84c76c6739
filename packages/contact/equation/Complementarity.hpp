#pragma once

#include "bem/base/Family.hpp"

namespace epafi::contact {

/// The contact conditions of one coefficient as an equation  F(λ, y, s) = 0.
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
  /// F and one element of its generalised gradient, a limit of gradients from nearby.
  struct Value {
    double value;
    double multiplier;   ///< ∂F/∂λ >= 0
    double penetration;  ///< ∂F/∂y <= 0
    double bound;        ///< ∂F/∂s
  };

  const char* name;
  const char* meaning;
  /// Whether F² is continuously differentiable, so that ½|F|² can serve a line search.
  bool meritIsSmooth;
  /// Whether its rows are those of active sets: of the projection.
  bool hasActiveSets;
  Value (*normal)(double multiplier, double penetration);
  Value (*tangential)(double multiplier, double slip, double bound);
};

/// All complementarity functions; a program may add others before it reads its first
/// scene.  A built-in one is one line in Complementarity.cpp.
bem::Family<Complementarity>& complementarities();

/// Two that parts of the solver ask for by name: active sets, and a smooth merit function.
const Complementarity& projection();
const Complementarity& fischerBurmeister();

}  // namespace epafi::contact
