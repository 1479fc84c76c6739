#pragma once

#include "bem/operators/SteklovPoincare.hpp"
#include "drivers/process/PhaseTimer.hpp"
#include "drivers/run/BodySpaces.hpp"

#include <vector>

namespace epafi::drivers {

/// The Steklov-Poincaré operators of all bodies, factored, as dense matrices or compressed.
/// Collective.
/// \param krylov solves with V; null: its factor does
/// \throws bem::NumericalError if a factorisation breaks down
std::vector<bem::SteklovPoincare> makeStiffness(const Scene& scene,
                                                const BodySpaces& spaces, bool compressed,
                                                const bem::SingleLayerSolver* krylov,
                                                const bem::Processes& processes,
                                                PhaseTimer& timer);

}  // namespace epafi::drivers
