#pragma once

#include "contact/problem/Problem.hpp"

namespace epafi::reference {

/// How much a state violates the contact conditions, in stresses: the largest of tension,
/// penetration over response, their complementarity, excess over the slip bound, slip
/// against or without full friction, imbalance.  Computed from D, d₀, G, q alone.
double violation(const contact::Problem& problem, const contact::State& state);

}  // namespace epafi::reference
