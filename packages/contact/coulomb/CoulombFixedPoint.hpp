#pragma once

#include "contact/coulomb/CoulombIteration.hpp"

namespace epafi::contact {

/// A whole Tresca problem per update of the slip bound; the update is shortened where the
/// bound's change does not fall.
class CoulombFixedPoint final : public CoulombSolver {
 public:
  using CoulombSolver::CoulombSolver;

  /// Ends with the update after which `steps` linear systems have been solved.
  Solution updates(const Problem& problem, const State& start, int steps) const;

 private:
  Solution solveSound(const Problem& problem, const State& start) const override;
  Solution firstBound(const Problem& problem, const State& start) const;
  Solution update(const Problem& problem, Solution before) const;
};

}  // namespace epafi::contact
