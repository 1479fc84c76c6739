#pragma once

#include "bem/quadrature/Gauss.hpp"
#include "contact/body/Coupling.hpp"
#include "contact/opposite/Opposite.hpp"

namespace epafi::contact {

/// What the multiplier that one body's side carries does to a body B that it meets:
///
///   C_ij = - ∫ χ_i d_i · φ_j∘P ds,   d_i: n or t of the side, P: Opposite::at,
///
/// of B's displacements, with the rotation of a B that has arcs.
struct MortarCoupling {
  std::vector<bem::Entry> entries;                ///< displacements of B by multipliers
  std::shared_ptr<const bem::Rotation> rotation;  ///< of B; null without arcs
  Vector rests;  ///< - ∫ χ_i d_i · (r - r_I)∘P ds, see bem::Rotation

  /// C u
  Vector pull(const Vector& u) const;
  /// force += Cᵀ λ
  void push(const Vector& multiplier, Vector& force) const;
};

/// For body B of this number.  Both bodies count in the same lengths and stresses.
MortarCoupling mortarCoupling(const bem::Mesh& side, const MultiplierSpace& multiplier,
                              const Opposite& opposite, const bem::Space& met,
                              int body = 0);

/// What integrates λ against displacements opposite, between two breaks: exact where both
/// elements are straight, so that P is linear, and to rounding where they turn.  Forces on B
/// are sums of this rule, so that actio is reactio.
const bem::Rule& mortarRule(const MultiplierSpace::ContactElement& contact,
                            const bem::Element& side, const bem::Element& met);

}  // namespace epafi::contact
