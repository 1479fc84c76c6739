#pragma once

#include "contact/problem/Problem.hpp"

namespace epafi::reference {

/// The slow twin of contact::solve: projected successive over-relaxation, one coefficient
/// at a time, the slip bound taken from the newest pressure; free rigid motions by
/// Uzawa's method on the augmented problem.  Needs a well-conditioned D.
///
/// \throws std::runtime_error if a million sweeps are not enough
contact::State projectedSor(const contact::Problem& problem);

/// How much a state violates the contact conditions, in stresses: the largest of tension,
/// penetration over response, their complementarity, excess over the slip bound, slip
/// against or without full friction, imbalance.  Computed from D, d₀, G, q alone.
double violation(const contact::Problem& problem, const contact::State& state);

}  // namespace epafi::reference
