#pragma once

#include "contact/problem/Problem.hpp"

#include <vector>

namespace epafi::contact {

enum class NormalState { Open, Closed };

/// None: the slip bound is zero.
enum class FrictionState { None, Stick, SlipForward, SlipBackward };

/// Contact state of each coefficient of a multiplier.
struct ContactState {
  std::vector<NormalState> normal;
  std::vector<FrictionState> tangential;  ///< SlipForward: λₜ = +s; SlipBackward: λₜ = -s
};

/// Closed if λ + c r > 0 (c: see Equation); slip if |λ + c r| >= s.
/// \param penetration r, by displacements where available (see Configuration): on slender
/// bodies
///   rounding errors of D λ would change states
ContactState classify(const Problem& problem, const State& state,
                      const Vector& penetration);

/// Frictional work λₜ,i rₜ,i >= 0 of each tangential coefficient, dimensionless; zero
/// unless it
/// slips.                                                      [doc/theory/paths.md, Energies]
Vector frictionWork(const Problem& problem, const State& state,
                    const Vector& penetration);

}  // namespace epafi::contact
