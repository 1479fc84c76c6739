#pragma once

#include "bem/tractions/TractionRows.hpp"
#include "contact/body/BodyInput.hpp"
#include "contact/body/Loads.hpp"

namespace epafi::contact {

/// The matrices that couple displacement and multiplier, stabilisation included.
///
///   B_ij = <χ_i, φ_j> - <γ χ_i, S φ_j>,  M_ij = <γ χ_j, χ_i>,  S^_ij = <γ S φ_j, S φ_i>
///                                                                        [doc/theory/contact.md]
///
/// With the tractions' columns R,  Bᵀ = C - R G,  S^ = R diag(γ) Rᵀ;  C and G are sparse,
/// so that B need not be kept beside R.
///
/// Form Density is the same with R = K' (V + G)⁻¹ E, N = <γ P_i, χ_j> in G's place,
/// M - Nᵀ X N in M's, X = Eᵀ (V + G)⁻¹ E, and no S^ (doc/theory/contact.md).
struct Coupling {
  Index unknowns = 0;  ///< displacements
  Index multipliers = 0;
  std::vector<bem::Entry> trace;  ///< C: displacements x multiplier, <χ_i, φ_j>
  /// What completed ends add to C in Bᵀ λ, see completeEnds; nothing on free
  /// displacements.
  std::vector<bem::Entry> completion;
  /// On arcs: ∫ χ_i d · (r - r_I) ds, which C and its completion feel beside, see
  /// bem::Rotation; `rotation` is null on straight boundaries.
  Vector traceOfRotation;
  Vector completionOfRotation;
  std::shared_ptr<const bem::Rotation> rotation;
  std::vector<bem::Entry> weights;  ///< G: columns of R x multiplier
  std::vector<bem::Entry> mass;     ///< M: multiplier x multiplier
  Vector gamma;                     ///< γ per contact element, dimensionless
  std::shared_ptr<const bem::TractionRows> tractions;    ///< S φ; empty: no S^
  std::shared_ptr<const bem::DensityResponse> response;  ///< Density; else null
  bem::LocalCompliance compliance;        ///< of the densities in X's order
  std::shared_ptr<const Matrix> columns;  ///< R
  std::vector<Index> start;               ///< of an element's columns in R

  /// γ becomes factor times as large, and all that is proportional to it.
  void weaken(double factor);

  /// M; with Density less Nᵀ X N.
  Matrix multiplierMass() const;
  /// M λ and λᵀ M λ, without forming M.
  Vector massTimes(const Vector& lambda) const;
  double multiplierWork(const Vector& lambda) const;
  /// ψᵀ G ψ, all that V + G has beyond V.
  double complianceWork(const Vector& density) const;
  /// <γ t_p, P_i> of all densities: on contact elements by the weights of TractionMoments, on
  /// pinned ones by their means.
  Vector complianceOf(const bem::Space& space, const Vector& onContacts,
                      const ParticularSolution& inside) const;
  /// r -= Nᵀ ψ
  void subtractWeighted(const Vector& density, Vector& r) const;
  /// See ContactProblem; zero without densities.  `ofInside`: the compliance of
  /// ResidualTerms.
  std::vector<bem::Vec2> meanSlacks(const Vector& lambda, const Vector& density,
                                    const Vector& ofInside) const;
  /// Bᵀ
  Matrix transposed() const;
  /// G λ: what the multiplier puts on each column of R.
  Vector weighted(const Vector& lambda) const;
  /// Bᵀ λ, completed ends included.
  Vector push(const Vector& lambda) const;

  /// B u
  Vector pull(const Vector& u) const;

  /// X with S^ = X Xᵀ has so many columns, and by rows the displacements.
  Index stabilisationColumns() const { return tractions->start.back(); }
  /// Its columns from `first` to before `last`.
  Matrix stabilisationHalf(Index first, Index last) const;
};

/// X w and wᵀ X w of a symmetric X.
Vector timesSymmetric(const Matrix& symmetric, const Vector& w);
double quadratic(const Matrix& symmetric, const Vector& w);

Coupling makeCoupling(const BodyInput& input, const MultiplierSpace& multiplier);

/// Its sparse parts alone, of Form None or Density, whose `weights` have the densities of
/// densityCompliance as rows.
Coupling makeLocalCoupling(const bem::Space& space, const MultiplierSpace& multiplier,
                           const Stabilization& stabilization, const bem::Lame& lame,
                           bem::Units units);

}  // namespace epafi::contact
