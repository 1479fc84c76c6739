#pragma once

#include "adaptivity/estimate/ContactCost.hpp"
#include "bem/base/Processes.hpp"

namespace epafi::adaptivity {

/// Multipliers that do the same work as λʰ on every displacement of the space:
///
///   λ̃ = λʰ + Σ_i c_i w_i,   w_i = e(t)/half before node i, -e(-t)/half after it,
///
/// for each node i between two contact elements (in both components) and, on the contact
/// element alone, for each node and component that a clamp takes.  <w_i, v> = 0 for all
/// continuous v of the mesh's degrees: the equations cannot tell λ̃ from λʰ, and what
/// bounds the error of u and ψ for one bounds it for the other, whatever c
/// (doc/theory/estimators.md).
///
/// Returns the factors of e(-t)/half and e(t)/half on each contact element for c that
/// makes the sum of the costs small: at most what it is for c = 0, and a mirrored scene
/// gets mirrored factors.
std::vector<AtEnds> equivalentMultiplier(const bem::Mesh& mesh,
                                         const contact::Conditions& conditions,
                                         const std::vector<ContactElement>& elements,
                                         const std::vector<ContactCost>& costs);

/// The factors of rank 0; all processes must call.  Processes of unlike rounding could
/// choose differently, and the two halves of one w would get different c.
std::vector<AtEnds> agree(const std::vector<AtEnds>& factors,
                          const bem::Processes& processes);

}  // namespace epafi::adaptivity
