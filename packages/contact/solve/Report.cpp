#include "contact/solve/Report.hpp"

#include <sstream>

namespace epafi::contact {

namespace {

// As the enumerators come.
constexpr const char* stages[] = {"full steps", "follow offset", "near start",
                                  "fixed point"};
constexpr const char* ends[] = {"converged",  "unfinished", "cycling",  "grows",
                                "not finite", "stalled",    "singular", "no balance",
                                "too large",  "too long",   "unsettled"};

}  // namespace

std::string told(const std::vector<StageRun>& runs) {
  std::string text;
  for (const StageRun& run : runs) {
    text += text.empty() ? "" : ", ";
    text += stages[static_cast<int>(run.stage)];
    text += " " + std::to_string(run.steps) + " " + ends[static_cast<int>(run.end)];
    if (!run.parts.empty())
      text += " (" + told(run.parts) + ")";
  }
  return text;
}

std::string meritsTold(const std::vector<StageRun>& runs) {
  std::ostringstream text;
  text.precision(3);
  for (const StageRun& run : runs) {
    for (std::size_t k = 0; k < run.merits.size(); ++k) {
      if (k == 0)
        text << "  " << stages[static_cast<int>(run.stage)] << ": ";
      text << run.merits[k] << (k + 1 < run.merits.size() ? ", " : "\n");
    }
    text << meritsTold(run.parts);
  }
  return text.str();
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
  report.failure = run.message;
  report.stages.push_back({stage, run.iterations, run.residual, run.end, {}, run.merits});
  report.changing.clear();
  if (run.end != End::Converged)
    report.changing = run.changing;
  return report;
}

Report joined(Report later, const Report& earlier) {
  later.newtonIterations += earlier.newtonIterations;
  later.coulombIterations += earlier.coulombIterations;
  later.setChanges.insert(later.setChanges.begin(), earlier.setChanges.begin(),
                          earlier.setChanges.end());
  later.stages.insert(later.stages.begin(), earlier.stages.begin(), earlier.stages.end());
  return later;
}

Report asOne(Report report, Stage stage) {
  const End end = report.converged()      ? End::Converged
                  : report.stages.empty() ? End::NoBalance
                                          : report.stages.back().end;
  report.stages = {{stage,
                    report.newtonIterations,
                    report.residual,
                    end,
                    std::move(report.stages),
                    {}}};
  return report;
}

}  // namespace epafi::contact
