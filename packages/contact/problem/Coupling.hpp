#pragma once

#include "bem/assembly/TractionRows.hpp"
#include "contact/problem/ContactProblem.hpp"
#include "contact/problem/Loads.hpp"

namespace epafi::contact {

/// The matrices that couple displacement and multiplier, stabilisation included.
///
///   B_ij = <χ_i, φ_j> - <γ χ_i, S φ_j>,  M_ij = <γ χ_j, χ_i>,  S^_ij = <γ S φ_j, S φ_i>
///                                                                        [design.md 4.1]
///
/// With the tractions' columns R,  Bᵀ = C - R G,  S^ = R diag(γ) Rᵀ;  C and G are sparse,
/// so that B need not be kept beside R.
struct Coupling {
  struct Entry {
    Index row;
    Index column;
    double value;
  };

  Index unknowns = 0;  ///< displacements
  Index multipliers = 0;
  std::vector<Entry> trace;    ///< C: displacements x multiplier, <χ_i, φ_j>
  std::vector<Entry> weights;  ///< G: traction columns x multiplier
  std::vector<Entry> mass;     ///< M: multiplier x multiplier
  Vector gamma;                ///< γ per contact element, dimensionless
  std::shared_ptr<const bem::TractionRows> tractions;  ///< S φ; empty: no stabilisation

  /// M, whole.
  Matrix multiplierMass() const;
  /// Bᵀ, my rows.
  Matrix transposed(const bem::DenseAlgebra& algebra) const;
  /// Bᵀ λ, replicated.
  Vector push(const bem::DenseAlgebra& algebra, const Vector& lambda) const;

  /// X with S^ = X Xᵀ has so many columns, and by rows the displacements (mine).
  Index stabilisationColumns() const { return tractions->start.back(); }
  /// Its columns from `first` to before `last`.
  Matrix stabilisationHalf(Index first, Index last) const;
};

Coupling makeCoupling(const ContactProblem::Input& input,
                      const MultiplierSpace& multiplier);

/// g_i = <g, χ_i>, dimensionless, and the strengths of the tangential coefficients.
struct Obstacle {
  Vector gap;  ///< per normal coefficient
  std::vector<Tangential> tangentials;
  double largestPenetration = 0;  ///< max of -g
};

/// \throws bem::InputError if a friction strength is negative or not finite, naming
/// boundary and point.
Obstacle makeObstacle(const bem::Mesh& mesh, const MultiplierSpace& multiplier,
                      bem::Units units);

}  // namespace epafi::contact
