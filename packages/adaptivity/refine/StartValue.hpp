#pragma once

#include "bem/mesh/Mesh.hpp"
#include "contact/multiplier/MultiplierSpace.hpp"
#include "contact/problem/Problem.hpp"

namespace epafi::adaptivity {

/// Interpolates a multiplier on another mesh of the same outline, at the Gauss points of
/// its contact elements.
///
/// Exact if each new element lies in one old element and has at least its degree, except
/// for bases that share nodes: a common coefficient is the mean of two.
/// \throws bem::NumericalError if the new mesh has contact where the old one has none
contact::Vector carryMultiplier(const bem::Mesh& fromMesh,
                                const contact::MultiplierSpace& from,
                                const contact::Vector& multiplier,
                                const bem::Mesh& toMesh,
                                const contact::MultiplierSpace& to);

/// Transfers a state to another mesh of the same outline: λ by carryMultiplier(), α
/// unchanged.  The new coefficients of λ may violate the contact conditions; Newton's
/// first step corrects that. An empty state stays empty.
contact::State carry(const bem::Mesh& from, const contact::MultiplierSpace& multiplier,
                     const contact::State& state, const bem::Mesh& to,
                     const contact::Conditions& conditions);

}  // namespace epafi::adaptivity
