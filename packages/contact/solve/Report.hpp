#pragma once

#include "bem/base/Error.hpp"
#include "contact/solve/Stage.hpp"

#include <string>
#include <vector>

namespace epafi::contact {

enum class Status { Converged, NotConverged };

/// What happened in a nonlinear solve.
struct Report {
  Status status = Status::NotConverged;
  int newtonIterations = 0;
  int coulombIterations = 0;     ///< updates of the slip bound; 0 where it is fixed
  double residual = 0;           ///< scaled: relative to Problem::stress
  double tolerance = 0;          ///< what it was compared with, rounding floor included
  std::vector<int> setChanges;   ///< coefficients that changed state, step by step
  std::vector<StageRun> stages;  ///< what was tried, in order; the last one decides
  std::string said;              ///< by the arithmetic, of a linear system that failed
  std::vector<Index> restless;  ///< coefficients still changing state, when not converged

  bool converged() const { return status == Status::Converged; }
};

struct Solution {
  State state;
  Report report;
};

/// The report after one more run.
/// \throws bem::NumericalError if the run met a number that is not finite.
Report extended(Report report, Stage stage, const NewtonRun& run, const Problem& problem);

/// What came first and what came next as one report.
Report joined(Report later, const Report& earlier);

/// All stages of a report as the parts of one.
Report asOne(Report report, Stage stage);

}  // namespace epafi::contact
