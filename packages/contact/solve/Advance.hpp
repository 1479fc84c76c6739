#pragma once

#include "contact/solve/Report.hpp"

#include <functional>

namespace epafi::contact {

/// How long the steps of a path may be.
struct Pace {
  double first = 0.25;
  double largest = 1;
  double smallest = 1.0 / 256;
};

/// How far a path led, and the solution there.
struct Advance {
  Solution solution;
  double reached = 0;
};

/// Follows a family of problems from the solution `begin` at the factor 0 to the factor 1,
/// each solution the start of the next: steps grow by half after success and are halved
/// after failure.  Ends unconverged where a step would become too short or `steps` linear
/// systems have been solved, with the last solution that there was.
///
/// `solveAt`: one problem of the family; its report is its own.
Advance advance(
    Solution begin, const Pace& pace, int steps,
    const std::function<Solution(double factor, const State& start)>& solveAt);

}  // namespace epafi::contact
