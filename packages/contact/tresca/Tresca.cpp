#include "contact/tresca/Tresca.hpp"

#include "bem/base/Error.hpp"
#include "contact/equation/Equilibrium.hpp"
#include "contact/newton/Sweeps.hpp"
#include "contact/tresca/InteriorPoint.hpp"

#include <algorithm>

namespace epafi::contact {

namespace {

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
    case End::NoBalance:
      return noBalance;
    default:
      return residual + ": not a number";
  }
}

/// Through the middle of the box, which knows no active sets, then Newton's last digits.
Solution throughTheMiddle(const Equation& sharp, Report report,
                          const SolverOptions& options) {
  constexpr int polishing = 20;
  const InteriorPoint middle = interiorPoint(sharp);
  NewtonRun run =
      runNewton(sharp, middle.unknowns, NewtonMethod::Newton, polishing, options.nox);
  run.iterations += middle.iterations;
  report = extended(std::move(report), Stage::InteriorPoint, run, sharp.problem());
  report.globalised = true;
  return {unpack(sharp.problem(), run.best), std::move(report)};
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

Attempt newtonSteps(const Equation& equation, const Vector& start, int maximumIterations,
                    const SolverOptions& options) {
  const NewtonRun run =
      runNewton(equation, start, NewtonMethod::Newton, maximumIterations, options.nox);
  return {run, extended({}, Stage::FullSteps, run, equation.problem())};
}

Attempt pivoting(const Equation& equation, const Vector& start, int maximumIterations,
                 const SolverOptions& options) {
  const NewtonRun run = runNewton(equation, smoothed(equation, start),
                                  NewtonMethod::Pivoting, maximumIterations, options.nox);
  return {run, extended({}, Stage::Pivoting, run, equation.problem())};
}

Attempt fullSteps(const Equation& equation, const State& start, int maximumIterations,
                  const SolverOptions& options) {
  const Vector from = pack(equation.problem(), start);
  const bool plain = !equation.hasActiveSets() || !isKnown(start);
  return plain ? newtonSteps(equation, from, maximumIterations, options)
               : pivoting(equation, from, maximumIterations, options);
}

Solution solveFixedBounds(const Problem& problem, const State& start,
                          const SolverOptions& options) {
  const Equation equation(problem, complementarityOf(options),
                          Equation::Bound::Differentiated, options.tolerance);
  auto [run, report] = fullSteps(equation, start, options.maximumIterations, options);
  // A motion that bounded friction does not hold, and pressure not at all: a proof.
  if (run.end == End::NoBalance)
    throw bem::NumericalError(noBalance);
  // Without rigid motions D is definite, and so are all matrices of Newton's.
  if (run.end == End::Singular && equation.hasActiveSets() && problem.rigidMotions() == 0)
    throw bem::NumericalError(run.message);
  if (run.end == End::Converged || run.end == End::Iterations)
    return {unpack(problem, run.last), std::move(report)};
  const Equation sharp(problem, complementarity("Projection"),
                       Equation::Bound::Differentiated, options.tolerance);
  if (report.stages.back().stage != Stage::Pivoting) {
    Attempt second = pivoting(sharp, run.best, options.maximumIterations, options);
    report = joined(std::move(second.report), report);
    if (report.status == Status::Converged)
      return {unpack(problem, second.run.last), std::move(report)};
  }
  return throughTheMiddle(sharp, std::move(report), options);
}

}  // namespace epafi::contact
