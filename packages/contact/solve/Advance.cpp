#include "contact/solve/Advance.hpp"

#include <algorithm>
#include <utility>

namespace epafi::contact {

Advance advance(
    Solution now, const Pace& pace, int steps,
    const std::function<Solution(double factor, const State& start)>& solveAt) {
  const int before = now.report.newtonIterations;
  double reached = 0;
  double step = pace.first;
  while (reached < 1) {
    // Rounding shall not leave a tiny last step.
    const double next = reached + step > 1 - 1e-9 ? 1 : reached + step;
    Solution trial = solveAt(next, now.state);
    trial.report = joined(std::move(trial.report), now.report);
    if (trial.report.converged()) {
      reached = next;
      step = std::min(1.5 * step, pace.largest);
      now = std::move(trial);
      continue;
    }
    step *= 0.5;
    now.report = std::move(trial.report);
    if (step < pace.smallest || now.report.newtonIterations - before >= steps)
      break;
  }
  return {std::move(now), reached};
}

}  // namespace epafi::contact
