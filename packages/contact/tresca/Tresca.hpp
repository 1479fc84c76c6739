#pragma once

#include "contact/coulomb/CoulombIteration.hpp"
#include "contact/nox/Newton.hpp"

namespace epafi::contact {

/// Newton's method with full steps, and what it did.
struct Attempt {
  NewtonRun run;
  Report report;
};

/// Does a start know something of the multiplier?
bool isKnown(const State& start);

/// Newton's steps as the user's list wants them.
Attempt newtonSteps(const Equation& equation, const Vector& start, int maximumIterations,
                    const SolverOptions& options);

/// Sweeps first, then Pivoting.  Only with active sets.
Attempt pivoting(const Equation& equation, const Vector& start, int maximumIterations,
                 const SolverOptions& options);

/// From a start that knows something of the solution, with active sets, pivoting(); else
/// newtonSteps().
Attempt fullSteps(const Equation& equation, const State& start, int maximumIterations,
                  const SolverOptions& options);

/// Solves a problem whose slip bounds do not depend on the pressure: none, or
/// Tresca's.
///
/// Newton; where its sets come back, its matrix is singular or the residual grows,
/// Pivoting from the best iterate; then the middle of the box, which knows no sets, and
/// Newton's last digits.
/// \throws bem::NumericalError see solve()
Solution solveFixedBounds(const Problem& problem, const State& start,
                          const SolverOptions& options);

/// The table's entry for the options.
const Complementarity& complementarityOf(const SolverOptions& options);

/// A report extended by one more run, which decides residual, status and reason.
Report extended(Report report, Stage stage, const NewtonRun& run, const Problem& problem);

/// What came first and what came next as one report; the later one decides.
Report joined(Report later, const Report& earlier);

/// A report whose stages are parts of one.
Report asOne(Report report, Stage stage);

}  // namespace epafi::contact
