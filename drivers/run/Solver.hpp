#pragma once

#include "bem/base/Processes.hpp"
#include "contact/solve/Settled.hpp"
#include "drivers/process/PhaseTimer.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/scene/Scene.hpp"

#include <functional>
#include <string>

namespace epafi::drivers {

/// Result of a solve, with the reason if it has not converged.
struct SolvedProblem {
  contact::Solution solution;
  std::string reason;
};

/// Why a solve did not converge and what in the scene might help; empty if it did.
std::string reasonOf(const contact::Report& report, const Scene& scene);

/// What a step comes to, likewise.
struct SettledProblem : contact::Settled {
  std::string reason;
};

/// contact::settled of solves with a reason.
SettledProblem settled(
    contact::ContactSystem& system,
    const std::function<SolvedProblem(const contact::State* before)>& solveFrom,
    const bem::Processes& processes);

/// Solves one problem as the scene's list Solver says: Newton's method by NOX, Tresca's
/// problem on it, and Coulomb's on that where the slip bound depends on the pressure.
///
/// Rank 0 broadcasts state, status, iterations, residual, tolerance and reason, so that
/// all ranks have the same bits; it alone has the histories of steps.  The timer's watch
/// receives the progress of long solves.
/// \param start,otherwise where it starts, and, if that fails, starts again, unless both are
///   the same; start() is called only where it is needed
/// \throws see contact::NonlinearSolver; exceptions of the watch.  On a path a
///   bem::NumericalError gives a report without a state, since the step may be tried in parts.
SolvedProblem solve(const contact::ContactSystem& system, const BodySpaces& spaces,
                    const std::function<contact::State()>& start,
                    const contact::State& otherwise, const bem::Processes& processes,
                    PhaseTimer& timer);

}  // namespace epafi::drivers
