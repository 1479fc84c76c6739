#pragma once

#include "drivers/output/Table.hpp"
#include "drivers/run/SolvedStep.hpp"

#include <functional>
#include <string>

namespace epafi::drivers {

/// Further columns of history.csv: the cells of a level, empty ones for null.
using MoreColumns = std::function<Cells(const SolvedLevel* level, const LevelRow& row)>;

/// The columns of errors, empty.
Cells errorColumns();

/// The errors of a scene's levels against the solution in a solution.hdf:
///
///   error, error_multiplier, error_energy    relative: of displacements and densities in the
///                                            norm (<W d, d> + <V δ, δ>)^½, of the multiplier
///                                            in (Σ h/p ‖λ - λ_ref‖² / μ)^½ over the elements
///                                            of the level, the scaled L² norm in place of
///                                            H^-1/2 [P sec. 8]; both over the energy norm of
///                                            the reference; of the energy
///   counted                                  1 if the largest error is ten times the
///                                            reference's estimate
///   effectivity                              estimate over the absolute energy-norm error
///   error_path, error_path_multiplier        on a path the largest of the steps whose times
///                                            the reference has, too, over its largest norm
///   error_path_friction                      of friction's work so far, over its total
///   error_path_step                          step of error_path: 1, 2, ...
///
/// Computed on the union of the two meshes, without further approximation.
/// \throws bem::InputError for a file that is no complete solution of the same bodies up to the
///   same time.
MoreColumns errorsAgainst(const std::string& file, const Scene& scene);

}  // namespace epafi::drivers
