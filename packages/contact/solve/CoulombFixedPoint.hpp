#pragma once

#include "contact/solve/CoulombIteration.hpp"

namespace epafi::contact {

/// A whole Tresca problem per update of the slip bound; the update is shortened where the
/// bound's change does not fall.
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
