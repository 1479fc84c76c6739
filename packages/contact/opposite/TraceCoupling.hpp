#pragma once

#include "bem/quadrature/Gauss.hpp"
#include "bem/space/Space.hpp"
#include "contact/opposite/Opposite.hpp"

#include <memory>
#include <vector>

namespace epafi::contact {

/// How a multiplier acts on the displacements of one body, its own or the opposite one: C_ij, the
/// work of χ_i d_i (d_i: n or t of the side) on the trace of φ_j, and its work on the exact
/// rotation less the interpolated one, if the body has arcs.
struct TraceCoupling {
  std::vector<bem::Entry> entries;                ///< displacements by multipliers
  std::shared_ptr<const bem::Rotation> rotation;  ///< of the body; null without arcs
  Vector rests;  ///< work on r - r_I by multipliers, see bem::Rotation

  /// C u
  Vector apply(const Vector& u) const;
  /// force += Cᵀ λ
  void addTranspose(const Vector& multiplier, Vector& force) const;
  /// transposed += Cᵀ
  void addTo(Matrix& transposed) const;
  /// Adds the coupling of a multiplier whose coefficient i has the number numberOf(i) here.
  template <class Numbers>
  void add(const TraceCoupling& part, const Numbers& numberOf) {
    for (const bem::Entry& entry : part.entries)
      entries.push_back({entry.row, numberOf(entry.column), entry.value});
    for (std::size_t i = 0; i < part.rests.size(); ++i)
      rests[at(numberOf(static_cast<Index>(i)))] += part.rests[i];
  }
};

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
