#pragma once

#include "bem/mesh/Mesh.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"

namespace epafi::adaptivity {

/// The multiplier of one mesh as a function on another mesh of the same outline, in the
/// other's coefficients: values at the Gauss points of each contact element.
///
/// Exact where a new element lies in one old one and has at least its degree, in every
/// basis but those that share nodes, where a common coefficient is the mean of two.
/// \throws bem::NumericalError where the other mesh has contact and this one has none.
contact::Vector carryMultiplier(const bem::Mesh& fromMesh,
                                const contact::MultiplierSpace& from,
                                const contact::Vector& multiplier,
                                const bem::Mesh& toMesh,
                                const contact::MultiplierSpace& to);

}  // namespace epafi::adaptivity
