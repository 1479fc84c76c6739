#pragma once

#include "contact/body/BodyInput.hpp"
#include "contact/body/Holding.hpp"
#include "contact/body/StabilisedBody.hpp"
#include "contact/opposite/Obstacle.hpp"

namespace epafi::contact {

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
///   A u = f - Bᵀ λ on what is neither clamped nor fixed,   u = u_D + A⁺ (f - Bᵀ λ) + R α
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

  /// Of a body of a system: tangentials, numbers of coefficients and the load's size alone.
  const Problem& numbers() const { return numbers_; }
  const bem::Space& space() const { return *space_; }
  const MultiplierSpace& multiplier() const { return multiplier_; }
  const Opposite& opposite() const { return *opposite_; }
  const Obstacle& obstacle() const { return obstacle_; }
  const Holding& holding() const { return *holding_; }
  const StabilisedBody& form() const { return *form_; }
  const HeldStiffness& stiffness() const { return *stiffness_; }
  const ResidualTerms& terms() const { return terms_; }

  /// g per normal coefficient, dimensionless: the part -g of numbers().offset that does
  /// not come from loads.
  const Vector& gap() const { return obstacle_.gap; }

  /// u of a state, all unknowns of the space, dimensionless; refined, so that the
  /// equations hold to the rounding of u (see BalancedStiffness).
  ///
  /// `oppositeForce`: Cᵀ λ of the multipliers that other bodies carry against this one, here and
  /// below; empty: there are none.
  Vector displacement(const State& state, const Vector& oppositeForce = {}) const;

  /// ψ of a state and its displacement, the traction as a density: V⁻¹ (K + 1/2) u, with Form
  /// Density (V + G)⁻¹ ((K + 1/2) u - N λ).
  Vector density(const State& state, const Vector& displacement) const;

  /// 1/2 <W u, u> + 1/2 <V ψ, ψ>, dimensionless.
  double strainEnergy(const State& state, const Vector& displacement) const {
    return form_->strainEnergy(displacement, state.multiplier, terms_);
  }

  /// ½ uᵀ A u + ½ λᵀ M λ, dimensionless: the strain energy and what the stabilisation adds
  /// to it.  What loads, clamps and friction do changes this by their work.
  double storedEnergy(const State& state, const Vector& displacement) const;

  /// f of the equations, see Loads, all unknowns: the Neumann data's where nothing acts inside.
  const Vector& load() const { return holding_->loads.load; }
  /// What is given and what acts inside by themselves; vectors are empty where nothing does.
  const Loads::OfInside& ofInside() const { return holding_->loads.inside; }

  /// A u + Bᵀ λ - f on prescribed displacements: what clamps do to the body; zero elsewhere.
  Vector clampForces(const State& state, const Vector& displacement,
                     const Vector& oppositeForce = {}) const;

  /// (A u + Bᵀ λ - f) · v: work of the clamps' forces on the body on the rigid motions v
  /// of Space::rigidMotions, all but the prescribed unknowns of v set to zero; u is the
  /// state's displacement, freed from rounding.
  /// Stabilisation included; what holds fixed rigid motions is not.
  Vector clampWork(const State& state, const Vector& displacement,
                   const Vector& oppositeForce = {}) const;

  /// γ₀ that the mesh has got, see Stabilization::gamma0; zero without stabilisation.
  double gamma0() const { return gamma0_; }

  /// Whether ψ stands for S u in the stabilisation: Form Density.
  bool byDensity() const { return form_->local().byDensity(); }

  /// γ (λ + ψ) of each contact element (as multiplier().elements() has them), averaged along it,
  /// under Form Density; else zero.  Dimensionless.
  std::vector<bem::Vec2> meanSlacks(const State& state, const Vector& density) const {
    return form_->local().meanSlacks(state.multiplier, density, terms_.compliance);
  }

  /// γ on a contact element (index into multiplier().elements()), dimensionless.
  double gamma(std::size_t contactElement) const {
    return form_->local().gamma[contactElement];
  }

  /// ρ: amplitude of the uniform traction that holds each fixed rigid motion (x, y,
  /// rotation about the boundary's centroid); zero for those not fixed.
  Vector fixedReactions(const State& state, const Vector& oppositeForce = {}) const;

  /// Σ u_i ∫ φ_i · r_k ds over what is not prescribed, what these tractions do work on: zero but
  /// for clamps and for what acts inside.
  Vector fixedMeans(const Vector& displacement) const;

  Index freeMotions() const { return holding_->free(); }
  /// The displacement that their sizes make.
  Vector moved(const double* motions) const;

  /// u for λ = 0 and α = 0, the loads that it is linear in (forces, then displacements given), and
  /// Rᵀ f of the free motions.
  Vector displacementOfLoads() const;
  Vector pushing() const;
  Vector rigidLoad() const;
  /// Size of what acts on the body, dimensionless; zero: nothing.
  double loadSize() const {
    return holding_->loads.size() + obstacle_.largestPenetration;
  }

 private:
  friend class ContactSystem;
  struct OfSystem {};
  ContactProblem(const Input& input, OfSystem);
  /// The same at another time of a path; the factor of A is shared.
  ContactProblem(const ContactProblem& same, const Conditions& conditions);

  /// Factors A, with a smaller gamma0 where the default is too large.
  /// \throws IndefiniteStiffness if it is not the default that is.
  void factor(const Input& input);
  void setLoads();
  /// The displacement under a force that is neither clamped nor rigid.
  Vector respond(Vector force) const;
  /// Bᵀ λ and what others press; the last multiplier's is kept, which several results ask for.
  Vector contactForce(const State& state, const Vector& oppositeForce) const;

  const bem::Space* space_;
  bem::Units units_;
  std::shared_ptr<Holding> holding_;
  MultiplierSpace multiplier_;
  std::shared_ptr<const Opposite> opposite_;
  std::shared_ptr<const StabilisedBody> form_;
  std::shared_ptr<const HeldStiffness> stiffness_{};
  Obstacle obstacle_;
  double gamma0_ = 0;
  ResidualTerms terms_{};  ///< their force is part of the holding's load
  Vector load_{};          ///< f - A u_D
  Vector constant_{};      ///< u_D and what Fix makes of it
  Problem numbers_{};
  struct Cached {
    Vector multiplier;
    Vector force;
  };
  mutable Cached cached_{};
};

/// \throws bem::InputError if the multiplier does not go with the form.
std::unique_ptr<const StabilisedBody> makeStabilisedBody(
    const BodyInput& input, const MultiplierSpace& multiplier);

}  // namespace epafi::contact
