#pragma once

#include "contact/law/NormalLaw.hpp"

namespace epafi::contact {

using bem::Index;

/// Compliance of the contact surfaces, a monotone addition to D:
///
///   r = d₀ - D λ + G α - Φ(λ),   Φ(λ) = L λ + Σ_i m_i φ_i(λ_i) e_i,   m_i = ∫ χ_i ds.
///
/// L, local to elements, symmetric and positive semidefinite: linear laws, elastic shear,
/// wear.
/// φ_i: nonlinear laws, coefficient by coefficient.                  [doc/theory/surfaces.md]
struct Surface {
  struct Place {
    Index coefficient = 0;  ///< i, a normal one
    double length = 0;      ///< m_i
    PointClosing law;
  };

  std::vector<bem::Entry> linear;  ///< L
  std::vector<Place> places;
  std::size_t wearing =
      0;  ///< number of last entries of L from wear, without stored energy

  bool empty() const { return linear.empty() && places.empty(); }

  /// Φ(λ)
  Vector closing(const Vector& multiplier) const;
  /// Stored energy ½ λᵀ L λ + Σ m_i ∫₀^λᵢ s φ_i'(s) ds, L without wear.
  double energy(const Vector& multiplier) const;

  /// Entries of Φ' at the tangent point.  Changes r to r of the tangent at λ, and its
  /// weights c to c/(1 + c m φ').  The tangent point p of each law solves
  ///
  ///   p + c m φ(p) = λ + c (r + m φ(λ)),
  ///
  /// where φ is differentiable even if it is not at λ; then λ + c r = p.
  ///                                                              [doc/theory/surfaces.md]
  std::vector<bem::Entry> linearise(const Vector& multiplier, Vector& r, Vector& c) const;
};

/// y += factor A x, A with these entries.
void addTimes(double factor, const std::vector<bem::Entry>& entries, const Vector& x,
              Vector& y);

}  // namespace epafi::contact
