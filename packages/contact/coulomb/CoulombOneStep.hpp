#pragma once

#include "contact/coulomb/CoulombIteration.hpp"

namespace epafi::contact {

/// One Newton step per update of the slip bound.                          [P sec. 7]
class CoulombOneStep final : public NonlinearSolver {
 public:
  explicit CoulombOneStep(const Tresca& tresca, const CoulombOptions& options = {})
      : NonlinearSolver(tresca.budget()), tresca_(tresca), options_(options) {}

 private:
  Solution solveSound(const Problem& problem, const State& start) const override;

  const Tresca& tresca_;
  CoulombOptions options_;
};

}  // namespace epafi::contact
