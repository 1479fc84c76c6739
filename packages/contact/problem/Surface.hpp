#pragma once

#include "contact/law/NormalLaw.hpp"

namespace epafi::contact {

using bem::Index;

/// What the surfaces of contacts yield by under its stresses, beside D and monotone as that is:
///
///   r = d₀ - D λ + G α - Φ(λ),   Φ(λ) = L λ + Σ_i m_i φ_i(λ_i) e_i,   m_i = ∫ χ_i ds.
///
/// L, local to elements, symmetric and positive semidefinite: linear laws, elastic shear.
/// A law that is not linear acts coefficient by coefficient.          doc/theory/surfaces.md
struct Surface {
  struct Place {
    Index coefficient = 0;  ///< a normal one
    double length = 0;      ///< m
    PointClosing law;
  };

  std::vector<bem::Entry> linear;  ///< L
  std::vector<Place> places;
  std::size_t wearing = 0;  ///< how many of the last of L are wear, which stores nothing

  bool empty() const { return linear.empty() && places.empty(); }

  /// Φ(λ)
  Vector closing(const Vector& multiplier) const;
  /// What is stored: ½ λᵀ L λ + Σ m_i ∫ s φ_i'(s) ds.
  double energy(const Vector& multiplier) const;

  /// Φ' of a tangent, and r, that of λ, by the tangent; c, the weights of r, as what r does to
  /// λ: c/(1 + c m φ').  A law's tangent touches where a place that responds by 1/c would be,
  ///
  ///   p + c m φ(p) = λ + c (r + m φ(λ)),
  ///
  /// which has a slope where λ may have none, and λ + c r = p.      [doc/theory/surfaces.md]
  std::vector<bem::Entry> linearise(const Vector& multiplier, Vector& r, Vector& c) const;
};

/// Σ entries × x, added to y times a factor.
void addTimes(double factor, const std::vector<bem::Entry>& entries, const Vector& x,
              Vector& y);

}  // namespace epafi::contact
