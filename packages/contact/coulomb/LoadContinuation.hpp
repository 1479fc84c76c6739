#pragma once

#include "contact/coulomb/CoulombIteration.hpp"

namespace epafi::contact {

/// Solves a problem with its load applied in steps,
///
///   t (d₀ + g) - g,   t q,   t = 1/n, 2/n, ..., 1,   n = options.loadSteps,
///
/// each solution the start of the next; a step that fails is halved, the next one after a
/// success is longer.  n = 1 is solve() from the given start, with steps only where its
/// globalised iteration fails.  `gap`: see ContactProblem::gap.
/// \throws see solve(); bem::InputError if there are not as many gaps as normal
///   coefficients.
Solution solveInLoadSteps(const Problem& problem, const Vector& gap, const State& start,
                          const SolverOptions& options);

}  // namespace epafi::contact
