#pragma once

#include "drivers/output/SolutionFile.hpp"
#include "drivers/scene/Scene.hpp"

#include <set>
#include <string>
#include <vector>

namespace epafi::drivers {

/// Reads the last level of the run in a folder, from which `scene` is continued.
///
/// Bodies, Geometry, Contacts, Constants, Tables, History, Discretization and the
/// parameters of the estimate (Adaptivity->Weights, Residual Factor) must be those of the
/// earlier run.  Solver, Output and the rest of Adaptivity may differ.  A last level that
/// has not converged is solved again; its rows are left out of the tables.
/// \throws bem::InputError with the file and its defect, or with the first key that
///   differs.
Checkpoint readRestart(const std::string& folder, const Scene& scene);

/// The path of the first of some keys in which two lists differ, keys of the names `without` not
/// looked at; empty if they are equal.
std::string difference(const Teuchos::ParameterList& a, const Teuchos::ParameterList& b,
                       const std::string& path, const std::vector<std::string>& keys,
                       const std::set<std::string>& without = {});

/// Checks that the sizes and indices of a level that was read fit the scene and its own
/// meshes; the checksum of the file cannot.
/// \throws bem::InputError with the defect.
void checkLevel(const Level& level, const Scene& scene);

}  // namespace epafi::drivers
