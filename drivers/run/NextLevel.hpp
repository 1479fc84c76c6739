#pragma once

#include "bem/base/Processes.hpp"
#include "drivers/run/Level.hpp"
#include "drivers/scene/Scene.hpp"

#include <string>
#include <variant>

namespace epafi::drivers {

/// What a level is computed from.
struct LevelStart {
  int level = 0;
  std::vector<bem::Mesh> meshes;      ///< one per body
  std::vector<contact::State> start;  ///< likewise; empty: from zero
  std::vector<PathPoint> path{};      ///< steps on this mesh that are known already
  std::vector<contact::RigidMotion> rigid{};  ///< where bodies without elasticity start
};

/// How a run ended.
struct Outcome {
  contact::Status status = contact::Status::Converged;
  std::string reason;
};

/// The meshes that the scene describes, started from zero.
LevelStart firstLevel(const Scene& scene);

/// "; the estimated error is ...", what a level lacks of Adaptivity->Tolerance; empty if it is
/// reached or not asked for.
std::string missingTo(const Scene& scene, const Level& level);

/// The level after a solved one, or why there is none.
///
/// Everything is taken from the numbers of the level and from the scene, so that a level
/// read from a file leads to the same next one as a level just computed.  Collective.
/// \throws bem::InputError if the pieces are no meshes on the scene's outlines.
std::variant<LevelStart, Outcome> nextLevel(const Scene& scene, const Level& level,
                                            const bem::Processes& processes);

/// Where a run goes on that ended with this level: nextLevel, but a level that has not
/// converged is solved again from the state it was left in.
std::variant<LevelStart, Outcome> levelAfterRestart(const Scene& scene,
                                                    const Level& level,
                                                    const bem::Processes& processes);

}  // namespace epafi::drivers
