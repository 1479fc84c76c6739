#pragma once

#include "bem/base/Processes.hpp"
#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <string>
#include <variant>

namespace epafi::drivers {

/// How a run ended.
struct Outcome {
  contact::Status status = contact::Status::Converged;
  std::string reason;
};

/// The level to begin with: first meshes of the scene, start value zero.  Where coarse multipliers cannot
/// balance the load of a body that contact alone holds, and finer ones can (a load above
/// the edge of its foot), elements are halved towards ends and corners of contacts.
/// \throws bem::InputError see checkRoom
Level firstLevel(const Scene& scene);

/// "; the estimated error is ...": by how much a level misses Adaptivity->Tolerance, and whether it
/// is no result, since the error is estimated larger than the solution (by Weights that tell);
/// empty if it is neither.
std::string missingTo(const Scene& scene, const Level& level);

/// The end of a run behind a level: not converged where that is no result and a Tolerance was asked for.
Outcome ended(const Scene& scene, const Level& level, const std::string& reason);

/// The level to solve after a solved one, or the end of the run.  Depends on the scene and the
/// numbers of the level only, so that restarts give the same levels.  Collective.
/// \throws bem::InputError if the pieces do not fit the scene's outlines
std::variant<Level, Outcome> nextLevel(const Scene& scene, const Level& level,
                                       const bem::Processes& processes);

/// Continues a run that ended with this level: nextLevel(), but a level that has not
/// converged is solved again, from its last state.
std::variant<Level, Outcome> levelAfterRestart(const Scene& scene, const Level& level,
                                               const bem::Processes& processes);

}  // namespace epafi::drivers
