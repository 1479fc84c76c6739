#pragma once

#include "contact/problem/Problem.hpp"

#include <vector>

namespace epafi::contact {

enum class NormalState { Open, Closed };

/// None: the bound is zero, so there is no friction to speak of.
enum class FrictionState { None, Stick, SlipForward, SlipBackward };

/// What each coefficient of a multiplier does.
struct ContactState {
  std::vector<NormalState> normal;
  std::vector<FrictionState> tangential;  ///< SlipForward: λₜ = +s; SlipBackward: λₜ = -s
};

/// Closed where λ + c r > 0 (c: see Equation); slip where |λ + c r| reaches the bound.
/// `penetration`: r, by displacements where there are any, see Configuration: what rounds in
/// D λ makes states of its own on slender bodies.
ContactState classify(const Problem& problem, const State& state,
                      const Vector& penetration);

/// Friction's work λₜ,i rₜ,i of each tangential coefficient that slips by r, of the others
/// zero, dimensionless.  None is negative.                    [doc/theory/paths.md, Energies]
Vector frictionWork(const Problem& problem, const State& state,
                    const Vector& penetration);

}  // namespace epafi::contact
