#pragma once

#include "drivers/History.hpp"
#include "drivers/PhaseTimer.hpp"
#include "drivers/Scene.hpp"

#include <functional>
#include <string>

namespace epafi::drivers {

class Ranks;

/// A level as it is handed out: valid during the call only.
struct SolvedLevel {
  const contact::Solved& solved;
  const bem::Vector& density;  ///< traction on the whole boundary, dimensionless
  LevelRow row;
};

/// How a run ended.
struct Outcome {
  contact::Status status = contact::Status::Converged;
  std::string reason;
};

/// Frictional contact from level to level: the whole method on one page.
///
/// `handOut` receives each level as soon as it is solved, converged or not; the first one
/// that is not is the last.  Collective; all ranks hand out the same.
/// \throws bem::InputError, bem::NumericalError, Interrupted; levels handed out stay
/// good.
Outcome solveLevels(const Scene& scene, const Ranks& ranks, PhaseTimer& timer,
                    const std::function<void(const SolvedLevel&)>& handOut);

}  // namespace epafi::drivers
