#pragma once

#include "bem/quadrature/Gauss.hpp"
#include "bem/space/Space.hpp"
#include "contact/opposite/Opposite.hpp"

#include <memory>
#include <vector>

namespace epafi::contact {

/// How the multiplier acts on the displacements of one body: C_ij, the work of χ_i d_i (d_i: n or t
/// of the side) on the trace of φ_j on sides of the body, less that on the trace φ_j∘P where it is the
/// opposite body (P: Opposite::at), and its work on the exact rotation less the interpolated one, if
/// the body has arcs.
struct TraceCoupling {
  std::vector<bem::Entry> entries;                ///< displacements by multipliers
  std::shared_ptr<const bem::Rotation> rotation;  ///< of the body; null without arcs
  Vector rests;  ///< work on r - r_I by multipliers, see bem::Rotation

  /// C u
  Vector apply(const Vector& u) const;
  /// r += C u
  void addApplied(const double* u, Vector& r) const;
  /// force += s Cᵀ λ
  void addTranspose(double s, const double* multiplier, double* force) const;
  /// transposed += Cᵀ
  void addTo(Matrix& transposed) const;
};

/// Sets to zero what is rounding of what a rigid motion does to multipliers: a disc that turns in its
/// hole does not press on it.
/// \param alongX, alongY  what the translations (1, 0) and (0, 1) do
/// \param motion  displacements, of which the largest matters
void dropRounding(const Vector& alongX, const Vector& alongY, const Vector& motion,
                  Vector& moved);

}  // namespace epafi::contact
