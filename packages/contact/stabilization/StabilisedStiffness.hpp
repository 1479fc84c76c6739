#pragma once

#include "bem/base/Material.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "contact/stabilization/Stabilization.hpp"

#include <vector>

namespace epafi::contact {

/// The elements whose projected tractions the stabilisation takes from the assembly: give
/// them to bem::assembleOperators.  Empty for the other forms.
std::vector<int> tractionElements(const MultiplierSpace& multiplier,
                                  const Stabilization& stabilization);

/// The space on a mesh, with the densities that the stabilisation wants on contact
/// elements.
bem::Space makeSpace(const bem::Mesh& mesh, const Conditions& conditions,
                     const Stabilization& stabilization);

/// What Form Density adds to V: γ <P_i, P_i> on contact elements.  Give it to
/// bem::SteklovPoincare.  Empty for the other forms.
bem::LocalCompliance densityCompliance(const bem::Space& space,
                                       const MultiplierSpace& multiplier,
                                       const Stabilization& stabilization,
                                       const bem::Lame& lame, bem::Units units);

/// S as the stabilisation of a contact problem on this space wants it, with all of the
/// above; whoever times its parts puts them together alone.
bem::SteklovPoincare makeStiffness(const bem::Space& space,
                                   const MultiplierSpace& multiplier,
                                   const Stabilization& stabilization,
                                   const bem::Lame& lame, bem::Units units);

}  // namespace epafi::contact
