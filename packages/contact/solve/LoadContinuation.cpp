#include "contact/solve/LoadContinuation.hpp"

#include "contact/equation/ProblemFamily.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <utility>

namespace epafi::contact {

namespace {

/// One load: a failure of any kind is a report.
Solution attempt(const NonlinearSolver& solver, const Problem& problem,
                 const State& start) {
  Solution solution;
  try {
    solution = solver.solve(problem, start);
  } catch (const bem::NumericalError& error) {
    solution.report = failed(error);
  }
  solution.report = asOne(std::move(solution.report), Stage::Load);
  return solution;
}

Solution followLoad(const NonlinearSolver& solver, const ProblemFamily& family,
                    int steps) {
  const double largest = 1.0 / steps;
  const double smallest = largest / 1024;
  Solution now;
  double reached = 0;
  for (double step = largest; reached < 1 && step >= smallest;) {
    // Rounding shall not leave a tiny last step.
    const double next = reached + step > 1 - 1e-9 ? 1 : reached + step;
    Solution trial = attempt(solver, family.at({next, 1}), now.state);
    trial.report = joined(std::move(trial.report), now.report);
    if (trial.report.converged()) {
      reached = next;
      step = std::min(1.5 * step, largest);
      now = std::move(trial);
    } else {
      step *= 0.5;
      now.report = std::move(trial.report);
    }
  }
  now.report.loadReached = reached;
  return now;
}

}  // namespace

bem::SchemaRows loadRows() {
  return {bem::Row("Load Steps", bem::Kind::Whole,
                   "equal steps in which the load is applied, each solution the start of "
                   "the next; a step that fails is halved")
              .unit("1")
              .standard("1")
              .range({1, 1000})};
}

int parseLoadSteps(const Teuchos::ParameterList& list) {
  return list.get<int>("Load Steps");
}

Solution solveInLoadSteps(const NonlinearSolver& solver, const Problem& problem,
                          const Vector& gap, const State& start, int steps) {
  return steps > 1 ? followLoad(solver, {problem, gap}, steps)
                   : solver.solve(problem, start);
}

}  // namespace epafi::contact
