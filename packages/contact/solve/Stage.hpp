#pragma once

#include "contact/newton/Newton.hpp"

#include <string>
#include <vector>

namespace epafi::contact {

/// The methods of which a solve is made.
enum class Stage {
  FullSteps,     ///< Newton's steps from the start, or from where sweeps lead
  FollowOffset,  ///< complementary pivoting from an offset that is solved
  NearStart,     ///< a few steps to a slip bound to begin with
  FixedPoint     ///< updates of the slip bound
};

/// What one of them did.
struct StageRun {
  Stage stage = Stage::FullSteps;
  int steps = 0;  ///< linear systems solved, those of its parts included
  double residual = 0;
  End end = End::Iterations;
  std::vector<StageRun> parts{};  ///< other methods that it ran
};

/// "full steps 17 restless, follow offset 5 converged"
std::string told(const std::vector<StageRun>& stages);

}  // namespace epafi::contact
