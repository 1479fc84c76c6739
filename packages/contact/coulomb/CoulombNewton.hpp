#pragma once

#include "contact/coulomb/CoulombIteration.hpp"

namespace epafi::contact {

/// Newton's method on the coupled problem, the derivative of the slip bound included.
class CoulombNewton final : public NonlinearSolver {
 public:
  explicit CoulombNewton(const Tresca& tresca, const CoulombOptions& options = {})
      : NonlinearSolver(tresca.budget()), tresca_(tresca), options_(options) {}

  /// Of a problem known to be sound.
  Solution solveSound(const Problem& problem, const State& start) const override;

 private:
  const Tresca& tresca_;
  CoulombOptions options_;
};

}  // namespace epafi::contact
