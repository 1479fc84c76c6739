#pragma once

#include "drivers/output/SolutionFile.hpp"
#include "drivers/scene/Scene.hpp"

#include <optional>

namespace epafi::drivers {

/// The last level of the run in a folder, for a scene to go on from.
///
/// The scene must say the same as the earlier run's about Bodies, Geometry, Contacts, Constants,
/// Tables, History, Discretization and how errors are estimated (Adaptivity->Weights, Residual Factor);
/// Solver, Output and the rest of Adaptivity may differ.  Of a level that has not converged, the row of
/// history.csv is left out: it is solved again.
/// \throws bem::InputError naming the file and what is wrong with it, or the first key
///   that differs.
Checkpoint readRestart(const std::string& folder, const Scene& scene);

/// The level in a file, or nothing if that is damaged, of another format or of a scene
/// that differs in more than Output.
std::optional<Checkpoint> readSolutionOf(const Scene& scene, const std::string& path);

}  // namespace epafi::drivers
