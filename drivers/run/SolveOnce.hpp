#pragma once

#include "bem/base/DenseAlgebra.hpp"
#include "bem/mesh/Mesh.hpp"
#include "contact/coulomb/CoulombIteration.hpp"
#include "contact/problem/ContactProblem.hpp"

namespace epafi::drivers {

/// contact::solveInLoadSteps on rank 0, its reason with the places that are undecided;
/// the others are told what came out of it, so that all go on with the same bits.  They
/// get state, status, iterations, residual, tolerance and reason; the histories of the
/// steps stay where they are.
contact::Solution solveOnce(const contact::ContactProblem& problem, const bem::Mesh& mesh,
                            const contact::State& start,
                            const contact::SolverOptions& options,
                            const bem::DenseAlgebra& algebra);

}  // namespace epafi::drivers
