#pragma once

#include "bem/quadrature/Gauss.hpp"
#include "contact/body/TraceCoupling.hpp"
#include "contact/opposite/Opposite.hpp"

namespace epafi::contact {

/// Mortar coupling of a multiplier with the displacements of the opposite body B, of this number
/// and with the space `other`:
///
///   C_ij = - ∫ χ_i d_i · φ_j∘P ds,   d_i: n or t of the side, P: Opposite::at.
///
/// \pre both bodies share Units
TraceCoupling mortarCoupling(const bem::Mesh& side, const MultiplierSpace& multiplier,
                             const Opposite& opposite, const bem::Space& other,
                             int body = 0);

/// Quadrature rule for λ times opposite displacements between two breaks: exact on straight
/// elements, where P is linear, and up to rounding on arcs.  Forces on both bodies use this
/// rule, so that they balance.
const bem::Rule& mortarRule(const MultiplierSpace::ContactElement& contact,
                            const bem::Element& side, const bem::Element& other);

}  // namespace epafi::contact
