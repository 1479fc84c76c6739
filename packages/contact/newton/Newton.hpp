#pragma once

#include "contact/equation/Equation.hpp"

#include <string>
#include <vector>

namespace epafi::contact {

/// Why a run of some method ended.
enum class End {
  Converged,
  Iterations,  ///< no convergence within the allowed steps
  Restless,    ///< a set of states came back and the residual had not fallen
  Growth,      ///< the residual grew beyond all measure
  NotFinite,
  Stalled,    ///< no step length decreases the merit function
  Singular,   ///< of the Newton matrix
  NoBalance,  ///< nothing balances the load with these bounds
  TooLarge,   ///< more coefficients than the method is for: not tried
  TooLong,    ///< it would take more work than a method may
  Unsettled   ///< the slip bound still changes after the allowed updates
};

/// What one run of Newton's method did.
struct NewtonRun {
  End end = End::Iterations;
  int iterations = 0;  ///< linear systems solved
  Vector last;
  Vector best;  ///< the iterate with the least residual
  double residual = 0;
  double tolerance = 0;
  std::vector<int> setChanges;
  std::vector<Index> restless;  ///< coefficients that changed in the last steps
  std::string message;          ///< of a singular Jacobian
};

/// Newton's method, whoever does its steps: see nox/NoxNewton.
class Newton {
 public:
  virtual ~Newton() = default;

  /// On F(x) = 0 from `start`.
  virtual NewtonRun run(const Equation& equation, const Vector& start,
                        int maximumIterations) const = 0;
};

}  // namespace epafi::contact
