#pragma once

#include "bem/base/Material.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "contact/stabilization/Stabilization.hpp"

#include <vector>

namespace epafi::contact {

/// Elements with a stabilisation: those in contact, then, under Form Density, those that others face.
std::vector<int> stabilisedElements(const bem::Mesh& mesh, const Conditions& conditions,
                                    const Stabilization& stabilization);

/// The space on a mesh, with the number of densities that the stabilisation needs on these
/// elements.
bem::Space makeSpace(const bem::Mesh& mesh, const Conditions& conditions,
                     const Stabilization& stabilization);

/// Compliance γ <P_i, P_i> on stabilised elements that Form Density adds to V, for
/// bem::SteklovPoincare.  Empty for other forms.
bem::LocalCompliance densityCompliance(const bem::Space& space,
                                       const Conditions& conditions,
                                       const Stabilization& stabilization,
                                       const bem::Lame& lame, bem::Units units);

/// S for a contact problem with this stabilisation, with densityCompliance().
bem::SteklovPoincare makeStiffness(const bem::Space& space, const Conditions& conditions,
                                   const Stabilization& stabilization,
                                   const bem::Lame& lame, bem::Units units);

}  // namespace epafi::contact
