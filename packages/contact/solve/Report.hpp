#pragma once

#include "contact/problem/Problem.hpp"

#include <string>
#include <vector>

namespace epafi::contact {

enum class Status { Converged, NotConverged };

/// Why a run of some method ended.
enum class End {
  Converged,
  Iterations,  ///< no convergence within the allowed steps
  Restless,    ///< a set of states came back and the residual had not fallen
  Growth,      ///< the residual grew beyond all measure
  NotFinite,
  Stalled,   ///< no step length decreases the merit function
  Singular,  ///< of the Newton matrix
  NoBalance  ///< nothing balances the load with these bounds
};

/// The methods of which a solve is made; those that others are part of come first.
enum class Stage {
  FullSteps,      ///< Newton's steps from the start
  Pivoting,       ///< sweeps, then chosen active sets
  InteriorPoint,  ///< the middle of the box, then Newton's last digits
  MeritDescent,   ///< Armijo's rule on the smooth merit function
  NearStart,      ///< a few steps to a slip bound to begin with
  FollowFriction,
  FixedPoint,  ///< updates of the slip bound
  Uncoupled,   ///< every slip bound follows its own pressure alone
  Load         ///< a part of the load
};

/// What one of them did.
struct StageRun {
  Stage stage = Stage::FullSteps;
  int steps = 0;  ///< linear systems solved, those of its parts included
  double residual = 0;
  End end = End::Iterations;
  std::vector<StageRun> parts{};  ///< other methods that it ran
};

/// What happened in a nonlinear solve.
struct Report {
  Status status = Status::NotConverged;
  int newtonIterations = 0;
  int coulombIterations = 0;     ///< updates of the slip bound; 0 where it is fixed
  double residual = 0;           ///< scaled: relative to Problem::stress
  double tolerance = 0;          ///< what it was compared with, rounding floor included
  std::vector<int> setChanges;   ///< coefficients that changed state, step by step
  bool globalised = false;       ///< full steps were given up for a line search
  std::vector<double> merits;    ///< the last descent's merit function, step by step
  std::vector<StageRun> stages;  ///< what was tried, in order; the last one decides
  std::string reason;  ///< empty when converged; else what happened and what to try
  std::vector<Index> restless;  ///< coefficients still changing state, when not converged
};

struct Solution {
  State state;
  Report report;
};

/// "full steps 17 restless, follow friction 23 converged (pivoting 9 converged, ...)"
std::string told(const std::vector<StageRun>& stages);

}  // namespace epafi::contact
