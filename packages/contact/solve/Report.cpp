#include "contact/solve/Report.hpp"

namespace epafi::contact {

namespace {

const char* nameOf(Stage stage) {
  switch (stage) {
    case Stage::FullSteps:
      return "full steps";
    case Stage::Pivoting:
      return "pivoting";
    case Stage::InteriorPoint:
      return "interior point";
    case Stage::MeritDescent:
      return "merit descent";
    case Stage::NearStart:
      return "near start";
    case Stage::FollowFriction:
      return "follow friction";
    case Stage::FixedPoint:
      return "fixed point";
    case Stage::Uncoupled:
      return "uncoupled";
    default:
      return "load";
  }
}

const char* nameOf(End end) {
  switch (end) {
    case End::Converged:
      return "converged";
    case End::Iterations:
      return "unfinished";
    case End::Restless:
      return "restless";
    case End::Growth:
      return "grows";
    case End::NotFinite:
      return "not finite";
    case End::Stalled:
      return "stalled";
    case End::Singular:
      return "singular";
    case End::NoBalance:
      return "no balance";
    default:
      return "unsettled";
  }
}

}  // namespace

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
  report.said = run.message;
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
  const End end = report.converged()      ? End::Converged
                  : report.stages.empty() ? End::NoBalance
                                          : report.stages.back().end;
  report.stages = {
      {stage, report.newtonIterations, report.residual, end, std::move(report.stages)}};
  return report;
}

Report failed(const bem::NumericalError& error) {
  Report report;
  report.said = error.what();
  return report;
}

std::string told(const std::vector<StageRun>& stages) {
  std::string text;
  for (const StageRun& run : stages) {
    text += text.empty() ? "" : ", ";
    text += nameOf(run.stage);
    text += " " + std::to_string(run.steps) + " " + nameOf(run.end);
    if (!run.parts.empty())
      text += " (" + told(run.parts) + ")";
  }
  return text;
}

}  // namespace epafi::contact
