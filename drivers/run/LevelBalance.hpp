#pragma once

#include "drivers/run/SolvedStep.hpp"

namespace epafi::drivers {

/// \pre imbalance.body
const std::string& nameOf(const contact::Imbalance& imbalance, const Scene& scene);

/// Of the bodies of a scene, before the first step.
contact::Balance balanceOf(const Scene& scene);

/// Sets the imbalances of a step that has converged.  Where one, or what is missing to its virtual
/// work, is larger than rounding and what the solver leaves, the level is not converged, and its
/// reason, which is in `unbalanced` too, says which body lacks what, or all works.
/// Collective.
void checkBalance(contact::Balance& balance, const Run& run, SolvedStep& step,
                  SolvedLevel& level);

}  // namespace epafi::drivers
