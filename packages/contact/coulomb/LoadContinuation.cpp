#include "contact/coulomb/LoadContinuation.hpp"

#include "bem/base/Error.hpp"
#include "contact/equation/ProblemFamily.hpp"
#include "contact/tresca/Tresca.hpp"

#include <algorithm>
#include <utility>

namespace epafi::contact {

namespace {

constexpr double smallestStep = 1.0 / 1024;
constexpr int fallbackSteps = 8;

/// One load: a failure of any kind is a report.
Solution attempt(const Problem& problem, const State& start,
                 const SolverOptions& options) {
  try {
    Solution solution = solve(problem, start, options);
    solution.report = asOne(std::move(solution.report), Stage::Load);
    return solution;
  } catch (const bem::NumericalError& error) {
    Solution failed;
    failed.report.reason = error.what();
    failed.report = asOne(std::move(failed.report), Stage::Load);
    return failed;
  }
}

Solution followLoad(const ProblemFamily& family, int steps, Report before,
                    const SolverOptions& options) {
  Solution now;
  now.report = std::move(before);
  double reached = 0;
  double step = 1.0 / steps;
  while (reached < 1) {
    // Rounding shall not leave a tiny last step.
    const double next = reached + step > 1 - 1e-9 ? 1 : reached + step;
    Solution trial = attempt(family.at({next, 1}), now.state, options);
    trial.report = joined(std::move(trial.report), now.report);
    if (trial.report.status == Status::Converged) {
      reached = next;
      step = std::min(1.5 * step, 1.0 / steps);
      now = std::move(trial);
      continue;
    }
    step *= 0.5;
    if (step < smallestStep) {
      trial.report.reason = bem::message("the load could be raised to ", reached,
                                         " of itself, not beyond: ", trial.report.reason);
      trial.report.status = Status::NotConverged;
      return {std::move(now.state), std::move(trial.report)};
    }
    now.report = std::move(trial.report);
  }
  return now;
}

}  // namespace

Solution solveInLoadSteps(const Problem& problem, const Vector& gap, const State& start,
                          const SolverOptions& options) {
  if (options.loadSteps > 1)
    return followLoad({problem, gap}, options.loadSteps, {}, options);
  Solution solution = solve(problem, start, options);
  const bool failed =
      solution.report.status != Status::Converged && solution.report.globalised;
  if (!failed)
    return solution;
  Solution followed = followLoad({problem, gap}, fallbackSteps, solution.report, options);
  if (followed.report.status == Status::Converged)
    return followed;
  // At full load the state says more than one of a part of the load.
  solution.report = std::move(followed.report);
  return solution;
}

}  // namespace epafi::contact
