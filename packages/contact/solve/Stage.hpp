#pragma once

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
};

/// "full steps 17 cycling, follow offset 5 converged"
std::string told(const std::vector<StageRun>& stages);

}  // namespace epafi::contact
