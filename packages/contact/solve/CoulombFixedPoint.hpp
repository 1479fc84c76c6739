#pragma once

#include "contact/solve/CoulombIteration.hpp"

namespace epafi::contact {

/// Fixed point iteration: each update of the slip bound solves a Tresca problem; updates are
/// damped if the change of the bound does not decrease.
class CoulombFixedPoint final : public CoulombSolver {
 public:
  using CoulombSolver::CoulombSolver;

 private:
  Solution solveSound(const Problem& problem, const State& start) const override;
  Solution updates(const Problem& problem, const State& start) const;
  Solution firstBound(const Problem& problem, const State& start) const;
  Solution update(const Problem& problem, Solution before) const;
};

}  // namespace epafi::contact
