#pragma once

#include "bem/quadrature/Gauss.hpp"
#include "contact/body/Coupling.hpp"
#include "contact/opposite/Opposite.hpp"

namespace epafi::contact {

/// Mortar coupling of a multiplier with the displacements of the opposite body B:
///
///   C_ij = - ∫ χ_i d_i · φ_j∘P ds,   d_i: n or t of the side, P: Opposite::at,
///
/// with the exact rotation of B if it has arcs.
struct MortarCoupling {
  std::vector<bem::Entry> entries;                ///< displacements of B by multipliers
  std::shared_ptr<const bem::Rotation> rotation;  ///< of B; null without arcs
  Vector rests;  ///< - ∫ χ_i d_i · (r - r_I)∘P ds, see bem::Rotation

  /// C u
  Vector pull(const Vector& u) const;
  /// force += Cᵀ λ
  void push(const Vector& multiplier, Vector& force) const;
};

/// Mortar coupling with body number `body`, whose space is `met`.  \pre both bodies share Units
MortarCoupling mortarCoupling(const bem::Mesh& side, const MultiplierSpace& multiplier,
                              const Opposite& opposite, const bem::Space& met,
                              int body = 0);

/// Quadrature rule for λ times opposite displacements between two breaks: exact on straight
/// elements, where P is linear, and up to rounding on arcs.  Forces on both bodies use this
/// rule, so that they balance.
const bem::Rule& mortarRule(const MultiplierSpace::ContactElement& contact,
                            const bem::Element& side, const bem::Element& met);

}  // namespace epafi::contact
