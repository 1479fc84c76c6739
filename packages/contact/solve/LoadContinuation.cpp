#include "contact/solve/LoadContinuation.hpp"

#include "contact/equation/ProblemFamily.hpp"
#include "contact/solve/Advance.hpp"

#include <Teuchos_ParameterList.hpp>

#include <limits>
#include <utility>

namespace epafi::contact {

namespace {

constexpr int fallbackSteps = 8;

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

Solution followLoad(const NonlinearSolver& solver, const ProblemFamily& family, int steps,
                    int most, Report before) {
  const double step = 1.0 / steps;
  Advance path = advance({{}, std::move(before)}, {step, step, 1.0 / 1024}, most,
                         [&](double load, const State& start) {
                           return attempt(solver, family.at({load, 1}), start);
                         });
  path.solution.report.loadReached = path.reached;
  return std::move(path.solution);
}

}  // namespace

bem::SchemaRows loadRows() {
  return {bem::Row("Load Steps", bem::Kind::Whole,
                   "equal steps in which the load is applied, each solution the start of "
                   "the next; a step that fails is halved, and one load that fails is "
                   "tried in steps")
              .unit("1")
              .standard("1")
              .range({1, 1000})};
}

int parseLoadSteps(const Teuchos::ParameterList& list) {
  return list.get<int>("Load Steps");
}

Solution solveInLoadSteps(const NonlinearSolver& solver, const Problem& problem,
                          const Vector& gap, const State& start, int steps) {
  if (steps > 1)
    return followLoad(solver, {problem, gap}, steps, std::numeric_limits<int>::max(), {});
  Solution solution = solver.solve(problem, start);
  if (solution.report.converged() || !solution.report.globalised)
    return solution;
  // At once and in steps may cost the same.
  Solution followed =
      followLoad(solver, {problem, gap}, fallbackSteps, solver.budget(), solution.report);
  if (followed.report.converged())
    return followed;
  // At full load the state says more than one of a part of the load.
  solution.report = std::move(followed.report);
  return solution;
}

}  // namespace epafi::contact
