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
ContactState classify(const Problem& problem, const State& state);

}  // namespace epafi::contact
