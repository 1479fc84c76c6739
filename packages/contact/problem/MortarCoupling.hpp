#pragma once

#include "contact/problem/Coupling.hpp"
#include "contact/problem/Opposite.hpp"

namespace epafi::contact {

/// The mortar coupling, a body opposite: Cᵀ of -u_B in the normal and tangent of the side,
///
///   C_ij = - ∫ χ_i d_i · φ_j∘P ds,   d_i: n or t of the side, P: Opposite::at,
///
/// displacements of B, the body of this number, by multipliers.  One rule for both sides of what it couples,
/// exact for polynomials where P is linear between its breaks, so that actio is reactio.
/// Both bodies count in the same lengths and stresses.
std::vector<Coupling::Entry> mortarCoupling(const bem::Mesh& side,
                                            const MultiplierSpace& multiplier,
                                            const Opposite& opposite,
                                            const bem::Space& met, int body = 0);

}  // namespace epafi::contact
