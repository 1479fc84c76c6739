#include "contact/coulomb/CoulombIteration.hpp"

#include "bem/base/Error.hpp"
#include "contact/coulomb/FrictionContinuation.hpp"
#include "contact/equation/Equilibrium.hpp"
#include "contact/tresca/Tresca.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace epafi::contact {

namespace {

constexpr double smallestDamping = 1.0 / 64;

double largestDifference(const Vector& a, const Vector& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// A bound to begin with: that of the start or, where it is zero and friction may have to
// hold the body, that after a few steps of the coupled problem.
Solution firstBound(const Problem& problem, const State& start, Report report,
                    const SolverOptions& options) {
  constexpr int steps = 5;
  const Vector bounds = problem.slipBounds(start.multiplier);
  const bool slippery =
      std::all_of(bounds.begin(), bounds.end(), [](double s) { return s <= 0; });
  if (problem.rigidMotions() == 0 || !slippery)
    return {start, std::move(report)};
  const Equation equation(problem, complementarityOf(options), Equation::Bound::Lagged,
                          options.tolerance);
  const NewtonRun run =
      runNewton(equation, pack(problem, start), NewtonMethod::Newton, steps, options.nox);
  return {unpack(problem, run.last),
          extended(std::move(report), Stage::NearStart, run, problem)};
}

// One update of the bound: Tresca's problem, its report added to what came before.
Solution update(const Problem& tresca, Solution before, const SolverOptions& options) {
  Report& report = before.report;
  report.coulombIterations += 1;
  try {
    Solution next = solveFixedBounds(tresca, before.state, options);
    next.report = joined(std::move(next.report), report);
    return next;
  } catch (const bem::NumericalError& error) {
    // With this bound there is no equilibrium; with the right one there may be.
    report.status = Status::NotConverged;
    report.reason = error.what();
    report.stages.push_back({Stage::FullSteps, 0, 0, End::NoBalance});
    return before;
  }
}

// A whole Tresca problem per update of the bound; the update is shortened when the
// bound's change does not fall.
Solution updates(const Problem& problem, const State& start,
                 const SolverOptions& options) {
  const double tolerance = std::max(options.tolerance, options.coulombTolerance);
  const Equation coulomb(problem, complementarityOf(options), Equation::Bound::Lagged,
                         tolerance);
  Solution solution = firstBound(problem, start, {}, options);
  Vector bounds = problem.slipBounds(solution.state.multiplier);
  Problem tresca = withSlipBounds(problem, bounds);
  double damping = 1;
  double change = 0;
  for (int k = 1; k <= options.coulombMaximumIterations; ++k) {
    for (std::size_t t = 0; t < bounds.size(); ++t)
      tresca.tangentials[t] = {problem.tangentials[t].normal(), PointLaw(bounds[t])};
    solution = update(tresca, std::move(solution), options);

    const Evaluation e = coulomb.at(pack(problem, solution.state));
    const double previous =
        std::exchange(change, largestDifference(e.bounds, bounds) / problem.stress);
    Report& result = solution.report;
    result.residual = e.scaled;
    result.tolerance = e.tolerance;
    if (result.status != Status::Converged) {
      result.reason = bem::message("Tresca's problem of update ", k,
                                   " of the slip bound: ", result.reason,
                                   ".  Try Solver->Coulomb Iteration = 'Newton'");
      return solution;
    }
    if (e.converged && change <= e.tolerance)
      return solution;
    if (k > 2 && change > 0.95 * previous) {
      damping = std::max(0.5 * damping, smallestDamping);
      result.globalised = true;
    }
    for (std::size_t t = 0; t < bounds.size(); ++t)
      bounds[t] += damping * (e.bounds[t] - bounds[t]);
  }
  solution.report.status = Status::NotConverged;
  solution.report.stages.push_back({Stage::FixedPoint, 0, change, End::Iterations});
  solution.report.reason =
      bem::message("the slip bound still changes by ", change, " of the load after ",
                   options.coulombMaximumIterations,
                   " updates: use Solver->Coulomb Iteration = 'Newton', or "
                   "raise Solver->Coulomb Maximum Iterations; with a large friction "
                   "coefficient there may "
                   "be several solutions, or none");
  return solution;
}

Solution fixedPoint(const Problem& problem, const State& start, const Report& before,
                    const SolverOptions& options) {
  Solution solution = updates(problem, start, options);
  solution.report = joined(asOne(std::move(solution.report), Stage::FixedPoint), before);
  return solution;
}

// What came first and what came next as one report; every step updates the bound.
Report joinedSteps(Report later, const Report& earlier) {
  later.coulombIterations = later.newtonIterations;
  return joined(std::move(later), earlier);
}

// What follows where Newton's steps fail.  Following friction costs a few of them each;
// the descent, that costs many, and updates of the bound are for bodies that only friction
// holds.
Solution withoutSets(const Problem& problem, const Vector& best, const Report& before,
                     const SolverOptions& options) {
  Solution solution = followFriction(problem, options);
  solution.report = joinedSteps(std::move(solution.report), before);
  if (solution.report.status == Status::Converged)
    return solution;
  const Equation smooth(problem, complementarity("Fischer-Burmeister"),
                        Equation::Bound::Differentiated, options.tolerance);
  const NewtonRun descent = runNewton(smooth, best, NewtonMethod::MeritDescent,
                                      2 * options.maximumIterations, options.nox);
  solution = {
      unpack(problem, descent.best),
      extended(std::move(solution.report), Stage::MeritDescent, descent, problem)};
  solution.report.coulombIterations += descent.iterations;
  if (descent.end == End::Converged)
    return solution;
  solution = fixedPoint(problem, unpack(problem, best), solution.report, options);
  if (solution.report.status != Status::Converged)
    solution.report.reason +=
        ".  Newton's method, following friction from zero, a line search and updates of "
        "the "
        "slip bound were tried; with a large friction coefficient there may be several "
        "solutions, or none: try a smaller one, a finer mesh, or Solver->Load Steps";
  return solution;
}

// Newton's method on the coupled problem, with or without the bound's derivative.
Solution newton(const Problem& problem, const State& start, Equation::Bound bound,
                const SolverOptions& options) {
  const bool lagged = bound == Equation::Bound::Lagged;
  const Equation equation(problem, complementarityOf(options), bound, options.tolerance);
  auto [run, report] = fullSteps(
      equation, start,
      lagged ? std::max(options.maximumIterations, options.coulombMaximumIterations)
             : options.maximumIterations,
      options);
  report.coulombIterations = report.newtonIterations;
  if (run.end == End::Converged || run.end == End::Iterations)
    return {unpack(problem, run.last), std::move(report)};

  return withoutSets(problem, run.best, report, options);
}

// Newton's method where bounds follow all pressures of an element.  From afar these make
// active sets wander; bounds that follow their own pressure alone do not, and bring near.
Solution coupledNewton(const Problem& problem, const State& start,
                       const SolverOptions& options) {
  const Equation equation(problem, complementarityOf(options),
                          Equation::Bound::Differentiated, options.tolerance);
  Solution near{start, {}};
  Vector best = pack(problem, start);
  const auto step = [&](Attempt attempt) {
    best = attempt.run.best;
    near = {unpack(problem, attempt.run.last),
            joinedSteps(std::move(attempt.report), near.report)};
    return near.report.status == Status::Converged;
  };
  if (isKnown(start) &&
      step(fullSteps(equation, start, options.maximumIterations, options)))
    return near;
  Solution uncoupled = newton(withUncoupledBounds(problem), start,
                              Equation::Bound::Differentiated, options);
  near = {std::move(uncoupled.state),
          joinedSteps(asOne(std::move(uncoupled.report), Stage::Uncoupled), near.report)};
  // Sweeps would lead away again.
  if (step(newtonSteps(equation, pack(problem, near.state), options.maximumIterations,
                       options)) ||
      (equation.hasActiveSets() &&
       step(pivoting(equation, best, options.maximumIterations, options))))
    return near;
  return withoutSets(problem, best, near.report, options);
}

}  // namespace

Solution solve(const Problem& problem, const State& start, const SolverOptions& options) {
  problem.check();
  if (!(problem.stress > 0) || !std::isfinite(problem.stress))
    throw bem::NumericalError("the contact problem's load has no positive, finite size");
  requireEquilibrium(problem);
  if (!problem.boundDependsOnPressure())
    return solveFixedBounds(problem, start, options);
  switch (options.coulomb) {
    case SolverOptions::Coulomb::FixedPoint:
      return fixedPoint(problem, unpack(problem, pack(problem, start)), {}, options);
    case SolverOptions::Coulomb::InexactFixedPoint:
      return newton(problem, start, Equation::Bound::Lagged, options);
    default:
      return problem.boundsAreCoupled()
                 ? coupledNewton(problem, start, options)
                 : newton(problem, start, Equation::Bound::Differentiated, options);
  }
}

}  // namespace epafi::contact
