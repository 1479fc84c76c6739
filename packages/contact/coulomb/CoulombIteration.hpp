#pragma once

#include "contact/problem/Problem.hpp"
#include "contact/solve/Report.hpp"

#include <memory>
#include <string>
#include <vector>

namespace Teuchos {
class ParameterList;
}

namespace epafi::contact {

/// How the nonlinear problem is solved.  Defaults are those of the scene's schema.
struct SolverOptions {
  enum class Coulomb {
    Newton,             ///< the slip bound is differentiated too
    InexactFixedPoint,  ///< one Newton step per update of the bound           [P sec. 7]
    FixedPoint          ///< a whole Tresca problem per update of the bound
  };
  enum class Complementarity { Projection, FischerBurmeister };

  Coulomb coulomb = Coulomb::Newton;
  Complementarity complementarity = Complementarity::Projection;
  double tolerance = 1e-12;  ///< scaled residual, relative to the load
  int maximumIterations = 50;
  int loadSteps = 1;                ///< see solveInLoadSteps()
  double coulombTolerance = 1e-10;  ///< change of the bound relative to the load
  int coulombMaximumIterations = 100;
  /// Handed to NOX in every run; null means Epafi's own choice.
  std::shared_ptr<const Teuchos::ParameterList> nox;
};

/// Solves a condensed contact problem, whatever its friction laws.
///
/// Frictionless and Tresca problems go to Newton directly; with a bound that depends on
/// the pressure the iteration of the options is used.  Slow convergence is reported, not
/// thrown.
/// \throws bem::NumericalError if the arithmetic breaks down (singular Jacobian, NaN) or
///   nothing balances the load; bem::InputError for what is wrong in options.nox.
Solution solve(const Problem& problem, const State& start, const SolverOptions& options);

}  // namespace epafi::contact
