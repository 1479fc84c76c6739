#pragma once

#include "contact/body/BodyInput.hpp"
#include "contact/body/Loads.hpp"
#include "contact/problem/Problem.hpp"

namespace epafi::contact {

struct BodyParts;
class ContactSystem;

/// The stabilised mixed problem [P (13)] on the mesh of one body, condensed onto the multiplier:
///
///   A u + Bᵀ λ = f,   (μ - λ)ᵀ (B u - M λ - g) <= 0 for all admissible μ
///                                                          [doc/theory/contact.md]
///
/// Eliminates all displacements once; numbers() is what the nonlinear solver sees,
/// displacement() leads back.  Of the mesh's operators it holds the factor of A and
/// refers to S.
///
/// A body of a ContactSystem is one of these, too: what its own multiplier does to it is here,
/// D and the offset are the system's.
class ContactProblem {
 public:
  using Input = BodyInput;

  /// \throws bem::InputError if the conditions contradict each other or leave a rigid
  ///   motion that is both fixed and clamped, or if `stiffness` was made for another
  ///   stabilisation; IndefiniteStiffness for a γ₀ that is given
  ///   and too large.
  explicit ContactProblem(const Input& input);
  ~ContactProblem();
  ContactProblem(ContactProblem&&) noexcept;

  /// Of a body of a system: tangentials, numbers of coefficients and the load's size alone.
  const Problem& numbers() const;
  const MultiplierSpace& multiplier() const;
  const Opposite& opposite() const;

  /// g per normal coefficient, dimensionless: the part -g of numbers().offset that does
  /// not come from loads.
  const Vector& gap() const;

  /// u of a state, all unknowns of the space, dimensionless; refined, so that the
  /// equations hold to the rounding of u (see BalancedStiffness).
  ///
  /// `met`: Cᵀ λ of the multipliers that other bodies carry against this one, here and
  /// below; empty: there are none.
  Vector displacement(const State& state, const Vector& met = {}) const;

  /// ψ of a state and its displacement, the traction as a density: V⁻¹ (K + 1/2) u, with Form
  /// Density (V + G)⁻¹ ((K + 1/2) u - N λ).
  Vector density(const State& state, const Vector& displacement) const;

  /// 1/2 <W u, u> + 1/2 <V ψ, ψ>, dimensionless.
  double strainEnergy(const State& state, const Vector& displacement) const;

  /// ½ uᵀ A u + ½ λᵀ M λ, dimensionless: the strain energy and what the stabilisation adds
  /// to it.  What loads, clamps and friction do changes this by their work.
  double storedEnergy(const State& state, const Vector& displacement) const;

  /// f of the equations, see Loads, all unknowns: the Neumann data's where nothing acts inside.
  const Vector& load() const;
  /// What is given and what acts inside by themselves; vectors are empty where nothing does.
  const Loads::OfInside& ofInside() const;

  /// A u + Bᵀ λ - f on prescribed displacements: what clamps do to the body; zero elsewhere.
  Vector clampForces(const State& state, const Vector& displacement,
                     const Vector& met = {}) const;

  /// (A u + Bᵀ λ - f) · v: work of the clamps' forces on the body on the rigid motions v
  /// of Space::rigidMotions, all but the prescribed unknowns of v set to zero; u is the
  /// state's displacement, freed from rounding.
  /// Stabilisation included; what holds fixed rigid motions is not.
  Vector clampWork(const State& state, const Vector& displacement,
                   const Vector& met = {}) const;

  /// γ₀ that the mesh has got, see Stabilization::gamma0; zero without stabilisation.
  double gamma0() const;

  /// Whether ψ stands for S u in the stabilisation: Form Density.
  bool byDensity() const;

  /// γ (λ + ψ) of each contact element (as multiplier().elements() has them), averaged along it,
  /// under Form Density; else zero.  Dimensionless.
  std::vector<bem::Vec2> meanSlacks(const State& state, const Vector& density) const;

  /// γ on a contact element (index into multiplier().elements()), dimensionless.
  double gamma(std::size_t contactElement) const;

  /// ρ: amplitude of the uniform traction that holds each fixed rigid motion (x, y,
  /// rotation about the boundary's centroid); zero for those not fixed.
  Vector fixedReactions(const State& state, const Vector& met = {}) const;

  /// Σ u_i ∫ φ_i · r_k ds over what is not prescribed, what these tractions do work on: zero but
  /// for clamps and for what acts inside.
  Vector fixedMeans(const Vector& displacement) const;

  Index freeMotions() const;
  /// The displacement that their sizes make.
  Vector moved(const double* motions) const;

 private:
  friend class ContactSystem;
  explicit ContactProblem(std::unique_ptr<BodyParts> parts);
  std::unique_ptr<BodyParts> parts_;
};

}  // namespace epafi::contact
