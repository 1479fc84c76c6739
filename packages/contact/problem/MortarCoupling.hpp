#pragma once

#include "bem/base/DenseAlgebra.hpp"
#include "bem/quadrature/Gauss.hpp"
#include "contact/problem/Opposite.hpp"

namespace epafi::contact {

/// The mortar coupling, a body opposite: Cᵀ of -u_B in the normal and tangent of the side,
///
///   C_ij = - ∫ χ_i d_i · φ_j∘P ds,   d_i: n or t of the side, P: Opposite::at,
///
/// my rows of the displacements of B, the body of this number, with the rotation of a B that
/// has arcs.  Both bodies count in the same lengths and stresses.
Matrix mortarCoupling(const bem::Mesh& side, const MultiplierSpace& multiplier,
                      const Opposite& opposite, const bem::Space& met,
                      const bem::DenseAlgebra& algebra, int body = 0);

/// What integrates λ against displacements opposite, between two breaks: exact where both
/// elements are straight, so that P is linear, and to rounding where they turn.  Forces on B
/// are sums of this rule, so that actio is reactio.
const bem::Rule& mortarRule(const MultiplierSpace::ContactElement& contact,
                            const bem::Element& side, const bem::Element& met);

}  // namespace epafi::contact
