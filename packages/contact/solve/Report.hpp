#pragma once

#include "contact/problem/Problem.hpp"

#include <string>
#include <vector>

namespace epafi::contact {

enum class Status { Converged, NotConverged };

/// What happened in a nonlinear solve.
struct Report {
  Status status = Status::NotConverged;
  int newtonIterations = 0;
  int coulombIterations = 0;    ///< updates of the slip bound; 0 where it is fixed
  double residual = 0;          ///< scaled: relative to Problem::stress
  double tolerance = 0;         ///< what it was compared with, rounding floor included
  std::vector<int> setChanges;  ///< coefficients that changed state, step by step
  bool globalised = false;      ///< full steps were given up for a line search
  std::vector<double> merits;   ///< the last descent's merit function, step by step
  std::string reason;  ///< empty when converged; else what happened and what to try
  std::vector<Index> restless;  ///< coefficients still changing state, when not converged
};

struct Solution {
  State state;
  Report report;
};

}  // namespace epafi::contact
