#pragma once

#include "contact/equation/Equation.hpp"

#include <string>
#include <vector>

namespace epafi::contact {

/// Why a run of a method ended.
enum class End {
  Converged,
  Iterations,  ///< no convergence within the allowed steps
  Cycling,     ///< an active set recurred without a smaller merit, or no progress
  Growth,      ///< the residual grew by a factor of a million
  NotFinite,
  Stalled,    ///< no step length decreases the merit function
  Singular,   ///< of the Newton matrix
  NoBalance,  ///< the load cannot be balanced with these bounds
  TooLarge,   ///< not tried: too many coefficients for the method
  TooLong,    ///< ended: more work than allowed
  Unsettled   ///< the slip bound still changes after the allowed updates
};

/// History and result of a run of Newton's method.
struct NewtonRun {
  End end = End::Iterations;
  int iterations = 0;           ///< linear systems solved
  Vector last;                  ///< last iterate x
  Vector best;                  ///< the iterate with the least merit
  double residual = 0;          ///< Evaluation::scaled of `last`
  double tolerance = 0;         ///< Evaluation::tolerance of `last`
  std::vector<int> setChanges;  ///< coefficients that changed state, one entry per step
  Vector merits;  ///< √(2Ψ) / Problem::stress of the start and after each step
  std::vector<Index> changing;  ///< coefficients that changed in the last steps
  std::string message;          ///< of a singular Jacobian
};

/// Interface of Newton's method; implemented by nox/NoxNewton.
class Newton {
 public:
  virtual ~Newton() = default;

  /// Solves F(x) = 0 from x = `start`.
  virtual NewtonRun run(const Equation& equation, const Vector& start,
                        int maximumIterations) const = 0;
};

}  // namespace epafi::contact
