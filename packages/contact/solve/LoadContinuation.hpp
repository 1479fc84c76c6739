#pragma once

#include "bem/base/SchemaRow.hpp"
#include "contact/solve/NonlinearSolver.hpp"

namespace Teuchos {
class ParameterList;
}

namespace epafi::contact {

/// The key of a number of load steps, and what a list that it has completed says.
bem::SchemaRows loadRows();
int parseLoadSteps(const Teuchos::ParameterList& list);

/// Solves a problem with its load applied in steps,
///
///   t (d₀ + g) - g,   t q,   t = 1/n, 2/n, ..., 1,   n = steps,
///
/// each solution the start of the next; a step that fails is halved, the next one after a
/// success is longer.  n = 1 is the solver's solve() from the given start.  `gap`: see ContactProblem::gap.
/// \throws see NonlinearSolver::solve; bem::InputError if there are not as many gaps as
///   normal coefficients.
Solution solveInLoadSteps(const NonlinearSolver& solver, const Problem& problem,
                          const Vector& gap, const State& start, int steps);

}  // namespace epafi::contact
