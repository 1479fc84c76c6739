#pragma once

#include "contact/body/Loads.hpp"
#include "contact/opposite/TraceCoupling.hpp"
#include "contact/stabilization/StabilisedStiffness.hpp"

#include <functional>

namespace epafi::contact {

/// At a point t of an element.
using BoundaryTraction = std::function<bem::Vec2(int element, double t)>;

/// The sparse matrices that couple a body and the multiplier, on its own sides and on those that face
/// it, stabilisation included.
///
///   B_ij = <χ_i, φ_j> - <γ χ_i, S φ_j>,  M_ij = <γ χ_j, χ_i>,  S^_ij = <γ S φ_j, S φ_i>
///                                                                        [doc/theory/contact.md]
///
/// With the tractions' columns R,  Bᵀ = C - R G,  S^ = R diag(γ) Rᵀ;  C and G are sparse,
/// so that B need not be kept beside R.
///
/// Form Density is the same with R = K' (V + G)⁻¹ E, N = <γ P_i, χ_j> in G's place,
/// M - Nᵀ X N in M's, X = Eᵀ (V + G)⁻¹ E, and no S^ (doc/theory/contact.md).  On elements f that sides
/// A of other bodies see, the residual is ψ - λ∘P⁻¹ ds_A/ds_f with P from A to f:
///
///   N_(f,l)i = -<γ_f χ_i d_i, P_l∘P>_A,   M_ij = <γ_f χ_i d_i, χ_j d_j ds_A/ds_f>_A
struct Coupling {
  const Opposite* opposite = nullptr;  ///< what directions depend on
  TraceCoupling trace;                 ///< C: <χ_i, φ_j>
  /// What completed ends, see completeEnds, add to C in Bᵀ λ on prescribed displacements, where no
  /// condition asks for it.  What quadrature on arcs leaves of them on others is part of C.
  TraceCoupling completion;
  std::vector<bem::Entry> weights;  ///< G: columns of R x multiplier
  std::vector<bem::Entry> mass;     ///< M: multiplier x multiplier
  Stabilization stabilization;
  double gamma0 = 0;  ///< see Stabilization::gamma0; zero without stabilisation
  /// See stabilisedElements, and γ on each, dimensionless.
  std::vector<int> elements;
  Vector gamma;
  bem::LocalCompliance compliance;  ///< of the densities in X's order
  std::vector<Index> start;         ///< of an element's columns in R

  /// Form Density on some element?
  bool byDensity() const { return !compliance.densities.empty(); }
  bool hasCompliance() const { return byDensity() || !compliance.pinned.empty(); }

  /// Coefficients of the multiplier that act on the body or its stabilisation, ascending.
  std::vector<Index> columns() const;

  /// Changes γ₀, and with it γ and all that is proportional to it.
  void weaken(double newGamma0);

  /// M λ
  Vector massTimes(const Vector& lambda) const;
  /// G λ: what the multiplier puts on each column of R.
  Vector weighted(const Vector& lambda) const;
  /// r -= Gᵀ w
  void subtractWeighted(const Vector& w, Vector& r) const;
  /// E w and Eᵀ ψ: from G's rows to all densities, and back.
  Vector onDensities(const Vector& w, Index densities) const;
  Vector ofDensities(const Vector& density) const;
  /// [C, -Gᵀ] by displacements and, behind them, all densities.
  TraceCoupling withDensities(Index displacements) const;
  /// ψᵀ G ψ, all that V + G has beyond V.
  double complianceWork(const Vector& density) const;
  /// <γ t_p, P_i> of all densities: on contact elements by the weights of Loads::OfInside, on
  /// pinned ones by their means.
  Vector complianceOf(const bem::Space& space, const Vector& onContacts,
                      const BoundaryTraction& traction) const;
  /// γ (λ + ψ) of each of the elements, averaged along it, under Form Density; else zero.
  /// `ofInside`: the compliance of Loads::OfInside.
  std::vector<bem::Vec2> meanSlacks(const Vector& lambda, const Vector& density,
                                    const Vector& ofInside) const;
};

/// Those of the places.
inline Vector entriesAt(const std::vector<Index>& places, const Vector& all) {
  Vector result;
  result.reserve(places.size());
  for (const Index i : places)
    result.push_back(all[at(i)]);
  return result;
}

/// C of all bodies, without stabilisation.  Refers to the opposite sides.
/// \pre all bodies share Units
/// \throws bem::InputError for a multiplier that shares nodes where contact with another body
///   meets a clamp or another contact side.
std::vector<Coupling> makeCouplings(const std::vector<const bem::Space*>& spaces,
                                    const MultiplierSpace& multiplier,
                                    const Opposite& opposite);

/// The same of one body with its stabilisation.
/// \throws bem::InputError with Form Density for an element that others see but Conditions::facing
/// does not hold
/// \param start of the elements' columns in R; empty: those of the densities, as without columns
Coupling stabilised(Coupling plain, const bem::Space& space,
                    const MultiplierSpace& multiplier, std::size_t body,
                    const Stabilization& stabilization, const bem::Lame& lame,
                    bem::Units units, std::vector<Index> start = {});

/// The `weights` and `terms` of a traction t, and <γ t, r> for the `tested` r.
Loads::InResidual tractionMoments(const MultiplierSpace& multiplier, std::size_t body,
                                  const Coupling& coupling,
                                  const BoundaryTraction& traction,
                                  const std::vector<BoundaryTraction>& tested);

}  // namespace epafi::contact
