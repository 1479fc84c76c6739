#include "contact/solve/Tresca.hpp"

#include "bem/base/Error.hpp"
#include "contact/solve/Equilibrium.hpp"
#include "contact/solve/InteriorPoint.hpp"
#include "contact/solve/Smoothing.hpp"

#include <algorithm>

namespace epafi::contact {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

std::string reasonOf(const NewtonRun& run) {
  const std::string residual =
      bem::message("scaled residual ", run.residual, ", tolerance ", run.tolerance,
                   " after ", run.iterations, " steps");
  switch (run.end) {
    case End::Converged:
      return "";
    case End::Iterations:
      return residual + ": raise Solver->Maximum Iterations";
    case End::Restless:
      return residual +
             ": the active sets repeat; use the other Solver->Complementarity, "
             "another Multiplier, or a finer mesh where the contact ends";
    case End::Growth:
      return residual + ": the residual grows; check load and units, or load in steps";
    case End::Stalled:
      return residual +
             ": no step length decreases the merit function; the problem may be too "
             "ill-conditioned for this Solver->Tolerance, or have no solution";
    case End::Singular:
      return residual + ": " + run.message;
    default:
      return residual + ": not a number";
  }
}

// Minimises the energy over the box; the equality constraint is the caller's.
NewtonRun minimise(const Problem& box, const Vector& start, double tolerance,
                   int maximumIterations) {
  const Equation equation(box, complementarity("Projection"),
                          Equation::Bound::Differentiated, tolerance);
  return runNewton(equation, start, NewtonMethod::ProjectedDescent, maximumIterations);
}

/// The augmented Lagrangian of  min ½ λᵀDλ - d₀ᵀλ,  Gᵀλ = q:  a sequence of box problems
///
///   D + ρ G W Gᵀ,   d₀ + G (α + ρ W q),   then  α ← α - ρ W (Gᵀλ - q).
///
/// W gives each motion size one.  Convex: converges for every ρ > 0.   [Rockafellar 1973]
class AugmentedLagrangian {
 public:
  AugmentedLagrangian(const Problem& problem, const Vector& weights)
      : problem_(problem), box_(withSlipBounds(problem, problem.slipBounds({}))) {
    const Index n = problem.size();
    Matrix d = problem.flexibility.entries().copy();
    for (Index j = 0; j < problem.rigidMotions(); ++j) {
      double sum = 0;
      for (Index i = 0; i < n; ++i)
        sum += weights[at(i)] * problem.rigid(i, j) * problem.rigid(i, j);
      penalty_.push_back(sum > 0 ? 100.0 * static_cast<double>(n) / sum : 0);
      for (Index b = 0; b < n; ++b)
        for (Index a = 0; a < n; ++a)
          d(a, b) += penalty_[at(j)] * problem.rigid(a, j) * problem.rigid(b, j);
    }
    box_.flexibility = std::move(d);
    box_.rigid = Matrix(n, 0);
    box_.rigidLoad.clear();
  }

  const Problem& boxProblem(const Vector& rigid) {
    box_.offset = problem_.offset;
    for (Index j = 0; j < problem_.rigidMotions(); ++j) {
      const double force = rigid[at(j)] + penalty_[at(j)] * problem_.rigidLoad[at(j)];
      for (Index i = 0; i < problem_.size(); ++i)
        box_.offset[at(i)] += problem_.rigid(i, j) * force;
    }
    return box_;
  }

  /// The change of α.
  Vector update(const Vector& multiplier) const {
    Vector change;
    for (Index j = 0; j < problem_.rigidMotions(); ++j) {
      double rest = problem_.rigidLoad[at(j)];
      for (Index i = 0; i < problem_.size(); ++i)
        rest -= problem_.rigid(i, j) * multiplier[at(i)];
      change.push_back(penalty_[at(j)] * rest);
    }
    return change;
  }

 private:
  const Problem& problem_;
  Problem box_;
  Vector penalty_;  // ρ W
};

Solution descendWithBalance(const Equation& equation, const Vector& start, Report report,
                            const SolverOptions& options) {
  constexpr int maximumUpdates = 40;
  constexpr int polishing = 4;
  const Problem& problem = equation.problem();
  const Vector bounds = problem.slipBounds({});
  // Near the solution active sets are found at once; the function of the options brought
  // us here.
  const Equation sharp(problem, complementarity("Projection"),
                       Equation::Bound::Differentiated, options.tolerance);
  AugmentedLagrangian lagrangian(problem, equation.weights());
  State state = unpack(problem, start);
  for (int update = 0; update < maximumUpdates; ++update) {
    const NewtonRun inner = minimise(lagrangian.boxProblem(state.rigid), state.multiplier,
                                     options.tolerance, options.maximumIterations);
    if (inner.end == End::Singular)
      throw bem::NumericalError(inner.message);
    report = extended(std::move(report), Stage::Descent, inner, problem);
    state.multiplier = inner.best;
    const Vector change = lagrangian.update(state.multiplier);
    requireBalance(problem, bounds, change);
    for (std::size_t j = 0; j < change.size(); ++j)
      state.rigid[j] += change[j];
    const NewtonRun polished =
        runNewton(sharp, pack(problem, state), NewtonMethod::Newton, polishing);
    report = extended(std::move(report), Stage::Balance, polished, problem);
    if (polished.end == End::Converged)
      return {unpack(problem, polished.last), std::move(report)};
  }
  return {std::move(state), std::move(report)};
}

/// Through the middle of the box, which knows no active sets, then Newton's last digits.
Solution throughTheMiddle(const Problem& problem, Solution before,
                          const SolverOptions& options) {
  constexpr int polishing = 20;
  const Equation sharp(problem, complementarity("Projection"),
                       Equation::Bound::Differentiated, options.tolerance);
  const InteriorPoint middle = interiorPoint(sharp);
  const NewtonRun polished =
      runNewton(sharp, middle.unknowns, NewtonMethod::Newton, polishing);
  before.report.newtonIterations += middle.iterations;
  before.report =
      extended(std::move(before.report), Stage::InteriorPoint, polished, problem);
  before.report.stages.back().steps += middle.iterations;
  before.report.globalised = true;
  return {unpack(problem, polished.best), std::move(before.report)};
}

NewtonRun pivot(const Equation& equation, const Vector& start, int maximumIterations) {
  return runNewton(equation, smoothed(equation, start), NewtonMethod::Pivoting,
                   maximumIterations);
}

}  // namespace

bool isKnown(const State& start) {
  return std::any_of(start.multiplier.begin(), start.multiplier.end(),
                     [](double x) { return x != 0; });
}

const Complementarity& complementarityOf(const SolverOptions& options) {
  return complementarity(options.complementarity ==
                                 SolverOptions::Complementarity::Projection
                             ? "Projection"
                             : "Fischer-Burmeister");
}

Report extended(Report report, Stage stage, const NewtonRun& run,
                const Problem& problem) {
  if (run.end == End::NotFinite)
    throw bem::NumericalError(
        bem::message("Newton's method met a number that is not finite after ",
                     run.iterations, " steps; the problem of ", problem.size(),
                     " coefficients is too badly "
                     "scaled or its flexibility is not positive definite"));
  report.status = run.end == End::Converged ? Status::Converged : Status::NotConverged;
  report.newtonIterations += run.iterations;
  report.residual = run.residual;
  report.tolerance = run.tolerance;
  report.setChanges.insert(report.setChanges.end(), run.setChanges.begin(),
                           run.setChanges.end());
  report.reason = reasonOf(run);
  report.stages.push_back({stage, run.iterations, run.residual, run.end});
  report.restless.clear();
  if (run.end != End::Converged)
    report.restless = run.restless;
  if (!run.merits.empty()) {
    report.globalised = true;
    report.merits = run.merits;
  }
  return report;
}

Report joined(Report later, const Report& earlier) {
  later.newtonIterations += earlier.newtonIterations;
  later.coulombIterations += earlier.coulombIterations;
  later.globalised = later.globalised || earlier.globalised;
  later.setChanges.insert(later.setChanges.begin(), earlier.setChanges.begin(),
                          earlier.setChanges.end());
  later.stages.insert(later.stages.begin(), earlier.stages.begin(), earlier.stages.end());
  return later;
}

Report asOne(Report report, Stage stage) {
  const End end = report.status == Status::Converged ? End::Converged
                  : report.stages.empty()            ? End::NoBalance
                                                     : report.stages.back().end;
  report.stages = {
      {stage, report.newtonIterations, report.residual, end, std::move(report.stages)}};
  return report;
}

Attempt fullSteps(const Equation& equation, const State& start, int maximumIterations,
                  const SolverOptions& options) {
  const Problem& problem = equation.problem();
  const bool plain = !equation.hasActiveSets() || !isKnown(start) ||
                     (options.nox != nullptr && hasOwnEntries(*options.nox));
  Attempt attempt;
  attempt.run = plain ? runNewton(equation, pack(problem, start), NewtonMethod::Newton,
                                  maximumIterations, options.nox)
                      : pivot(equation, pack(problem, start), maximumIterations);
  attempt.report =
      extended({}, plain ? Stage::FullSteps : Stage::Pivoting, attempt.run, problem);
  // From far off, following friction from zero costs less under a law of the pressure.
  if (plain && equation.hasActiveSets() && !problem.boundDependsOnPressure() &&
      attempt.run.end == End::Restless) {
    attempt.run = pivot(equation, attempt.run.best, maximumIterations);
    attempt.report =
        extended(std::move(attempt.report), Stage::Pivoting, attempt.run, problem);
  }
  return attempt;
}

Solution solveFixedBounds(const Problem& problem, const State& start,
                          const SolverOptions& options) {
  const Equation equation(problem, complementarityOf(options),
                          Equation::Bound::Differentiated, options.tolerance);
  auto [run, report] = fullSteps(equation, start, options.maximumIterations, options);
  if (run.end == End::Converged || run.end == End::Iterations)
    return {unpack(problem, run.last), std::move(report)};
  // Sets that come back move by a coefficient a step; the descent's would, too.
  const bool middleFirst =
      run.end == End::Restless && equation.hasActiveSets() && problem.rigidMotions() == 0;
  if (middleFirst) {
    Solution middle =
        throughTheMiddle(problem, {unpack(problem, run.best), report}, options);
    if (middle.report.status == Status::Converged)
      return middle;
    report = std::move(middle.report);
  }
  Solution descended;
  if (problem.rigidMotions() > 0) {
    descended = descendWithBalance(equation, run.best, std::move(report), options);
  } else {
    const NewtonRun descent =
        minimise(problem, run.best, options.tolerance, options.maximumIterations);
    if (descent.end == End::Singular)
      throw bem::NumericalError(descent.message);
    descended = {unpack(problem, descent.best),
                 extended(std::move(report), Stage::Descent, descent, problem)};
  }
  return middleFirst || descended.report.status == Status::Converged
             ? descended
             : throughTheMiddle(problem, std::move(descended), options);
}

}  // namespace epafi::contact
