#pragma once

#include "drivers/process/PhaseTimer.hpp"
#include "drivers/run/Level.hpp"
#include "drivers/run/NextLevel.hpp"
#include "drivers/scene/Scene.hpp"

#include <functional>
#include <optional>

namespace epafi::drivers {

class Ranks;

/// Frictional contact from level to level: the whole method on one page.
///
/// `handOut` receives each level as soon as it is solved, converged or not; the first one
/// that is not is the last.  With `earlier`, the result of a level of an earlier run, the
/// run goes on behind that level as if it had never stopped, see levelAfterRestart.
/// `handOutStep` receives each step of a path likewise, its level not complete, without a
/// row and indicators.
/// Collective; all ranks hand out the same.
/// \throws bem::InputError, bem::NumericalError, Interrupted; levels handed out stay
/// good.
Outcome solveLevels(const Scene& scene, const Ranks& ranks, PhaseTimer& timer,
                    const std::function<void(const SolvedLevel&)>& handOut,
                    const std::optional<Level>& earlier = {},
                    const std::function<void(const SolvedLevel&)>& handOutStep = {});

}  // namespace epafi::drivers
