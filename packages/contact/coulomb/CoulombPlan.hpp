#pragma once

#include "contact/coulomb/CoulombIteration.hpp"

namespace epafi::contact {

/// Newton's method on the coupled problem, the derivative of the slip bound included, and
/// what follows where it fails: a plan of stages.
class CoulombNewton final : public CoulombSolver {
 public:
  using CoulombSolver::CoulombSolver;

 private:
  Solution solveSound(const Problem& problem, const State& start) const override;
};

/// One Newton step per update of the slip bound, by a plan likewise.         [P sec. 7]
class CoulombOneStep final : public CoulombSolver {
 public:
  using CoulombSolver::CoulombSolver;

 private:
  Solution solveSound(const Problem& problem, const State& start) const override;
};

}  // namespace epafi::contact
