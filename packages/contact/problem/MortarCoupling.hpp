#pragma once

#include "bem/base/DenseAlgebra.hpp"
#include "contact/problem/Opposite.hpp"

namespace epafi::contact {

/// The mortar coupling, a body opposite: Cᵀ of -u_B in the normal and tangent of the side,
///
///   C_ij = - ∫ χ_i d_i · φ_j∘P ds,   d_i: n or t of the side, P: Opposite::at,
///
/// my rows of the displacements of B, the body of this number.  One rule for both sides of what it couples,
/// exact for polynomials where P is linear between its breaks, so that actio is reactio.
/// Both bodies count in the same lengths and stresses.
Matrix mortarCoupling(const bem::Mesh& side, const MultiplierSpace& multiplier,
                      const Opposite& opposite, const bem::Space& met,
                      const bem::DenseAlgebra& algebra, int body = 0);

}  // namespace epafi::contact
