#pragma once

#include "drivers/process/PhaseTimer.hpp"
#include "drivers/run/NextLevel.hpp"
#include "drivers/run/SolvedStep.hpp"

#include <functional>
#include <optional>

namespace epafi::drivers {

class Ranks;

/// Solves level after level, until a limit or a tolerance ends the run, or a level does
/// not converge. Collective.
/// \param handOut called with each solved level, the same on all ranks; also with one that
///   has not converged, which is the last
/// \param earlier a level of an earlier run, after which this one continues, see
///   levelAfterRestart
/// \param handOutStep called after each step of a path, with a Level that is not complete,
///   without indicators
/// \throws bem::InputError, bem::NumericalError, Interrupted; earlier calls stay valid
Outcome solveLevels(const Scene& scene, const Ranks& ranks, PhaseTimer& timer,
                    const std::function<void(const SolvedLevel&)>& handOut,
                    const std::optional<Level>& earlier = {},
                    const std::function<void(const SolvedLevel&)>& handOutStep = {});

}  // namespace epafi::drivers
