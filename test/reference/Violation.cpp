#include "reference/Violation.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::reference {

namespace {

using contact::Index;
using contact::Problem;
using contact::State;
using contact::Vector;

// The penetration or slip that a uniform multiplier of size one makes at i.
double response(const Problem& problem, Index i) {
  const bool normal = i < problem.normals;
  double sum = 0;
  for (Index j = 0; j < problem.size(); ++j)
    sum += (j < problem.normals) == normal ? std::abs(problem.flexibility(i, j)) : 0.0;
  return sum;
}

}  // namespace

double violation(const Problem& problem, const State& state) {
  const Vector closing = problem.surface.closing(state.multiplier);
  // where surfaces yield lengths count as the pressures that make them, down to rounding
  Vector yields(state.multiplier.size(), 0.0);
  for (const auto& [i, length, law] : problem.surface.places)
    yields[i] = length * law.slope(std::max(state.multiplier[i], 1e-12 * problem.stress));
  double worst = 0;
  const auto count = [&](double value) {
    worst = std::isfinite(value) ? std::max(worst, value) : HUGE_VAL;
  };
  for (Index i = 0; i < problem.size(); ++i) {
    double r = problem.offset[i] - closing[i];
    for (Index j = 0; j < problem.size(); ++j)
      r -= problem.flexibility(i, j) * state.multiplier[j];
    for (Index j = 0; j < problem.rigidMotions(); ++j)
      r += problem.rigid(i, j) * state.rigid[j];
    const double y = r / (response(problem, i) + yields[i]);
    const double x = state.multiplier[i];
    if (i < problem.normals) {
      count(-x);
      count(y);
      count(std::min(std::abs(x), std::abs(y)));
    } else {
      const double s = problem.tangentials[i - problem.normals].bound(state.multiplier);
      if (std::isfinite(s))  // else bonded
        count(std::abs(x) - s);
      // Slip to one side needs full friction on that side.
      count(std::min(y, s - x));
      count(std::min(-y, s + x));
    }
  }
  for (Index j = 0; j < problem.rigidMotions(); ++j) {
    double rest = problem.stiffness(j) * state.rigid[j] - problem.rigidLoad[j];
    double scale = 0;
    for (Index i = 0; i < problem.size(); ++i) {
      rest += problem.rigid(i, j) * state.multiplier[i];
      scale += std::abs(problem.rigid(i, j));
    }
    count(std::abs(rest) / scale);
  }
  return worst;
}

}  // namespace epafi::reference
