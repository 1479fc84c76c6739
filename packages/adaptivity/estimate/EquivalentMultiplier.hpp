#pragma once

#include "adaptivity/estimate/ContactCost.hpp"
#include "bem/base/Processes.hpp"

namespace epafi::adaptivity {

/// The multiplier λ̃ with the same work as λʰ on all displacements of the space that
/// makes the sum of the costs small:
///
///   λ̃ = λʰ + Σ_i c_i w_i,   w_i = e(t)/half before node i, -e(-t)/half after it,
///
/// for each node i between two contact elements (both components) and at each end of a
/// contact for the components that the neighbour's Dirichlet condition prescribes (on the
/// contact element only).  Since <w_i, v> = 0 for all continuous v of the mesh's degrees
/// that are zero where prescribed, an error bound with λ̃ is one with λʰ, for all c.
///                                                               [doc/theory/estimators.md]
///
/// Returns the factors of e(-t)/half and e(t)/half on each contact element.  The sum of
/// costs is at most that for c = 0.  A mirrored scene gets mirrored factors.
std::vector<AtEnds> equivalentMultiplier(const bem::Mesh& mesh,
                                         const contact::Conditions& conditions,
                                         const std::vector<ContactElement>& elements,
                                         const std::vector<ContactCost>& costs);

/// The factors of rank 0.  Collective.  With different rounding errors, processes could
/// choose different c for the two halves of one w.
std::vector<AtEnds> agree(const std::vector<AtEnds>& factors,
                          const bem::Processes& processes);

/// λ̃ - λʰ on all contact elements, alike on all ranks.  Collective.
/// \param factors of the terms, for the shear modulus lame.mu
/// \param moments ∫ r e(-t) ds and ∫ r e(t) ds of the residual λʰ + S u on each contact element,
///   zero on other processes' elements
std::vector<AtEnds> corrections(const contact::Solved& solved, const bem::Lame& lame,
                                const Contributions& factors,
                                const std::vector<AtEnds>& moments, SidePlaces& places,
                                const bem::Processes& processes);

}  // namespace epafi::adaptivity
