#pragma once

#include "contact/solve/Report.hpp"

namespace epafi::contact {

/// Solves condensed contact problems of one kind of friction.
class NonlinearSolver {
 public:
  virtual ~NonlinearSolver() = default;

  /// Slow convergence is reported, not thrown.
  /// \throws bem::NumericalError if the arithmetic breaks down (singular Jacobian, NaN);
  ///   NoBalance if nothing balances the load; and exceptions of Newton for its options
  Solution solve(const Problem& problem, const State& start) const;

 private:
  /// \pre the problem is sound
  virtual Solution solveSound(const Problem& problem, const State& start) const = 0;
};

}  // namespace epafi::contact
