#pragma once

#include "contact/nox/Newton.hpp"
#include "contact/solve/CoulombIteration.hpp"

namespace epafi::contact {

/// Newton's method with full steps, and what it did.
struct Attempt {
  NewtonRun run;
  Report report;
};

/// Does a start know something of the multiplier?
bool isKnown(const State& start);

/// From a start that knows something of the solution, with active sets and without a list
/// of NOX's of the user's own: sweeps first, then Pivoting.  Else plain full steps and,
/// where their sets come back under fixed bounds, the same from the best iterate.
Attempt fullSteps(const Equation& equation, const State& start, int maximumIterations,
                  const SolverOptions& options);

/// Solves a problem whose slip bounds do not depend on the pressure: none, or
/// Tresca's.
///
/// fullSteps(); where these wander, grow or meet a singular Jacobian,
/// the energy of the quadratic programme  min ½ λᵀDλ - d₀ᵀλ  over the box, Gᵀλ = q  takes
/// over. It falls with each step and so cannot cycle.  Gᵀλ = q is reached by an augmented
/// Lagrangian, whose last digits come from Newton's steps again.
/// \throws
/// bem::NumericalError see solve()
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
