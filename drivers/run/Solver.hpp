#pragma once

#include "bem/base/Processes.hpp"
#include "contact/path/Prediction.hpp"
#include "contact/solve/Report.hpp"
#include "contact/system/ContactSystem.hpp"
#include "drivers/process/PhaseTimer.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/scene/Scene.hpp"

#include <string>

namespace epafi::drivers {

/// A solved problem, and in words why it is not if it is not.
struct SolvedProblem {
  contact::Solution solution;
  std::string reason;
};

/// Solves one problem as the scene's list Solver says: Newton's method by NOX, Tresca's
/// problem on it, and Coulomb's on that where the slip bound depends on the pressure.
///
/// Rank 0 solves and tells the others, so that all go on with the same bits.  They get
/// state, status, iterations, residual, tolerance and reason; the histories of the steps
/// stay where they are.  The timer's watch is told how far what takes long is.
/// \throws see contact::NonlinearSolver; what the watch throws
SolvedProblem solve(const Scene& scene, const contact::ContactSystem& system,
                    const BodySpaces& spaces, const contact::State& start,
                    const bem::Processes& processes, PhaseTimer& timer);

/// The same for a step of a path: from a start, if none from where it is predicted, and if that
/// fails from the state before.  It may fail and be tried in parts: a bem::NumericalError is
/// the reason of a report without a state.
SolvedProblem solveStep(const Scene& scene, const contact::ContactSystem& system,
                        const BodySpaces& spaces, const contact::Prediction& prediction,
                        const contact::State* better, const bem::Processes& processes,
                        PhaseTimer& timer);

}  // namespace epafi::drivers
