#pragma once

#include "bem/base/Error.hpp"
#include "contact/newton/Newton.hpp"

#include <string>
#include <vector>

namespace epafi::contact {

/// The methods within a solve.
enum class Stage {
  FullSteps,     ///< Newton steps from the start, or from the result of sweeps
  FollowOffset,  ///< complementary pivoting from an offset with known solution
  NearStart,     ///< a few Newton steps for an initial slip bound
  FixedPoint     ///< updates of the slip bound
};

/// Result of a stage.
struct StageRun {
  Stage stage = Stage::FullSteps;
  int steps = 0;  ///< linear systems solved, including those of parts
  double residual = 0;
  End end = End::Iterations;
  std::vector<StageRun> parts{};  ///< other methods that it ran
  Vector merits{};                ///< NewtonRun::merits of its last run
};

/// "full steps 17 cycling, follow offset 5 converged"
std::string told(const std::vector<StageRun>& stages);
/// A line for each run of Newton's steps: "  full steps: 1.1, 0.3, 2e-3, 4e-14"
std::string meritsTold(const std::vector<StageRun>& stages);

enum class Status { Converged, NotConverged };

/// Convergence history of a nonlinear solve.
struct Report {
  Status status = Status::NotConverged;
  int newtonIterations = 0;
  int coulombIterations = 0;     ///< updates of the slip bound; 0 if it is given
  double residual = 0;           ///< scaled: relative to Problem::stress
  double tolerance = 0;          ///< for the residual, at least its rounding error
  std::vector<int> setChanges;   ///< coefficients that changed state, step by step
  std::vector<StageRun> stages;  ///< in order; the last one determines the status
  std::string failure;           ///< message of a linear system that failed
  std::vector<Index> changing;  ///< coefficients still changing state, when not converged

  bool converged() const { return status == Status::Converged; }
};

struct Solution {
  State state;
  Report report;
};

/// The report after one more run.
/// \throws bem::NumericalError if the run met a number that is not finite.
Report extended(Report report, Stage stage, const NewtonRun& run, const Problem& problem);

/// Concatenates two reports.
Report joined(Report later, const Report& earlier);

/// A report with one stage, whose parts are the stages of `report`.
Report asOne(Report report, Stage stage);

}  // namespace epafi::contact
