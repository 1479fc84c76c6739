#include "contact/system/SlipIteration.hpp"

#include "bem/algebra/SmallAlgebra.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace epafi::contact {

namespace {

/// S, and S' by its pieces.
using Map = std::function<Vector(const Vector& s)>;

Matrix derivativeOf(const Map& map, const Vector& s) {
  constexpr double step = 1e-7;
  const Vector here = map(s);
  Matrix result(static_cast<Index>(s.size()), static_cast<Index>(s.size()));
  for (std::size_t j = 0; j < s.size(); ++j) {
    Vector moved = s;
    moved[j] += step;
    const Vector there = map(moved);
    for (std::size_t i = 0; i < s.size(); ++i)
      result(static_cast<Index>(i), static_cast<Index>(j)) = (there[i] - here[i]) / step;
  }
  return result;
}

/// Number of solves until S - s is nothing.
int solvesOf(const Map& map, const Vector& start) {
  constexpr int most = 400;
  SlipIteration iteration;
  iteration.take(start, true, {});
  for (int k = 1; k <= most; ++k) {
    const Vector next = map(iteration.slips());
    Vector left = next;
    bem::axpy(-1, iteration.slips(), left);
    if (bem::largestEntry(left) <= 1e-12)
      return k;
    iteration.take(
        next, true,
        iteration.wantsResponse() ? derivativeOf(map, iteration.slips()) : Matrix());
  }
  return most + 1;
}

// What sticks as soon as it wears, beside places that settle slowly.
TEUCHOS_UNIT_TEST(SlipIteration, settlesWhatTurnsBeyondAnyShare) {
  const Map map = [](const Vector& s) {
    return Vector{std::max(1 - 60 * (s[0] - 0.1), 0.0), 0.5 + 0.9 * s[1] - 0.3 * s[0],
                  0.2 + 0.7 * s[2] + 0.05 * s[1]};
  };
  const int solves = solvesOf(map, {0, 0, 0});
  out << solves << " solves\n";
  TEST_COMPARE(solves, <, 200);
}

// Imaginary parts larger than what a share of an eighth damps.
TEUCHOS_UNIT_TEST(SlipIteration, settlesWhatTurnsInCircles) {
  const Map map = [](const Vector& s) {
    return Vector{std::max(1 + 0.8 * s[0] - 12 * (s[1] - 2), 0.0),
                  std::max(0.5 + 0.8 * s[1] + 12 * (s[0] - 1), 0.0), 0.3 + 0.6 * s[2]};
  };
  const int solves = solvesOf(map, {3, 1, 0});
  out << solves << " solves\n";
  TEST_COMPARE(solves, <, 200);
}

// The first solves are Aitken's: a multiple of the change before, of either sign.
TEUCHOS_UNIT_TEST(SlipIteration, takesThreeSolvesForOneMultiple) {
  for (const double multiple : {0.75, -3.0}) {
    const Map map = [=](const Vector& s) { return Vector{1 + multiple * s[0]}; };
    TEST_COMPARE(solvesOf(map, {0.5}), <=, 5);
  }
}

}  // namespace

}  // namespace epafi::contact
