#pragma once

#include "contact/body/ElasticBody.hpp"
#include "contact/opposite/Obstacle.hpp"

#include <functional>

namespace epafi::contact {

/// A body of a ContactSystem at one time, multipliers and states those of all bodies: the stabilised mixed problem [P (13)] on its mesh,
///
///   A u + Bᵀ λ = f,   (μ - λ)ᵀ (B u - M λ - g) <= 0 for all admissible μ
///                                                          [doc/theory/contact.md]
///
/// and its displacement for a given multiplier,
///
///   A u = f - Bᵀ λ on what is neither clamped nor fixed,   u = u_D + A⁺ (f - Bᵀ λ) + R α.
///
/// What Fix holds needs tractions Σ ρ r, ρ = R'(Bᵀ λ - f), which the residual of the stabilisation
/// knows: they follow from λ, with a motion of what Fix holds, and are no further unknowns.
///                                                 [doc/theory/contact.md, Reactions of Fix]
///
/// Of the mesh's operators it holds the factor of A and refers to S.
class ContactBody {
 public:
  /// \throws bem::InputError if the conditions contradict each other or leave a rigid
  ///   motion that is both fixed and clamped, or if `stiffness` was made for another
  ///   stabilisation; IndefiniteStiffness for a γ₀ that is given
  ///   and too large.
  /// \param number  of the body among those of the obstacle
  /// \param firstMotion  number of its first motion in State::rigid
  ContactBody(const BodyInput& input, std::shared_ptr<const Obstacle> obstacle,
              std::shared_ptr<const ElasticBody> elastic, std::size_t number,
              Index firstMotion);
  /// The same at another time of a path; the factor of A is shared.
  ContactBody under(std::shared_ptr<const Obstacle> obstacle) const;

  const bem::Space& space() const { return *space_; }
  bem::Units units() const { return units_; }
  const Obstacle& obstacle() const { return *obstacle_; }
  const Holding& holding() const { return elastic_->holding(); }

  /// The multiplier of all bodies, and what of it is on this one.
  const MultiplierSpace& multiplier() const { return obstacle_->multiplier; }
  const std::vector<MultiplierSpace::ContactElement>& elements() const {
    return multiplier().elements(number_);
  }
  const std::vector<Index>& columns() const { return multiplier().columns(number_); }
  std::size_t number() const { return number_; }
  const Conditions& conditions() const { return multiplier().conditions(number_); }
  const Opposite& opposite() const { return *obstacle_->opposite; }
  const std::shared_ptr<const ElasticBody>& elastic() const { return elastic_; }
  const Coupling& coupling() const { return elastic_->coupling(); }

  /// Problem::stress of the system, which sets it.
  double stress() const { return stress_; }
  void setStress(double stress) { stress_ = stress; }

  /// u of a state, all unknowns of the space, dimensionless; refined, so that the
  /// equations hold to the rounding of u (see DenseBody).
  ///
  /// `contactForce`, here and below: Bᵀ λ.
  /// \param feet  of its bedding, if it has one
  Vector displacement(const State& state, const Vector& contactForce,
                      const Vector& feet = {}) const;
  Vector displacement(const State& state) const {
    return displacement(state, contactForce(state.multiplier));
  }
  /// Bᵀ λ, of the multiplier on its sides and on those that face it, with forces on clamps and corners;
  /// empty: zero.
  Vector contactForce(const Vector& multiplier) const;

  /// B u, and M λ.
  Vector apply(const Vector& u) const;
  Vector massTimes(const Vector& multiplier) const;
  /// B u - M λ, with what reactions add.
  Vector penetration(const Vector& displacement, const Vector& multiplier,
                     const Vector& contactForce) const;

  /// ψ of a state and its displacement, the traction as a density: V⁻¹ (K + 1/2) u, with Form
  /// Density (V + G)⁻¹ ((K + 1/2) u - N λ - g).
  Vector density(const State& state, const Vector& displacement,
                 const Vector& contactForce) const;

  /// What a state and its displacement amount to, dimensionless.
  struct Results {
    Vector density;  ///< see density()
    /// A u + Bᵀ λ - f on prescribed displacements: what clamps do to the body; zero elsewhere.
    Vector clampForces;
    /// 1/2 <W u, u> + 1/2 <V ψ, ψ>
    double strainEnergy = 0;
    /// ½ uᵀ A u + ½ λᵀ M λ, λ without the reactions' tractions: the strain energy and what the
    /// stabilisation adds to it.  What loads, clamps and friction do changes this by their work.
    double storedEnergy = 0;
  };
  /// By one product with A, and one more where there are clamps.
  Results results(const State& state, const Vector& displacement,
                  const Vector& contactForce) const;
  /// storedEnergy - strainEnergy; with Form Density by itself, as an integral: without body loads
  /// ½ Σ ∫ γ |λ + ψ - Σ ρ r|².
  double stabilisationEnergy(const State& state, const Vector& displacement,
                             const Vector& contactForce, const Results& results) const;

  /// What sides that face it press on a point with, by its own arc length, and where that jumps inside an
  /// element, in [-1, 1], unsorted.
  bem::Vec2 foreignTraction(const Vector& multiplier,
                            const std::vector<Opposite::Source>& point) const;
  std::vector<Opposite::Source> sources(int element, double t) const {
    return opposite().sources(static_cast<int>(number_), element, t);
  }
  Vector sourceBreaks(int element) const {
    return opposite().sourceBreaks(static_cast<int>(number_), element);
  }

  /// What acts on it: f of the equations and, by themselves, what is given and what acts inside.
  const Loads& loads() const { return loads_; }

  /// (A u + Bᵀ λ - f) · v: work of Results::clampForces on the rigid motions v of RigidModes.
  /// Stabilisation included; what holds fixed rigid motions is not.
  Vector clampWork(const Vector& clampForces) const;

  /// ρ: amplitude of the uniform traction that holds each fixed rigid motion (x, y,
  /// rotation about the boundary's centroid); zero for those not fixed.
  Vector fixedReactions(const Vector& contactForce) const;

  /// What is given of ∫ u · r_k ds over what is not prescribed, on which these tractions do work:
  /// zero but for clamps and for what acts inside.
  Vector fixedMeans() const;

  /// What the traction -r of a fixed motion does in the residual λ + t_p - Σ ρ r + S u, with the
  /// displacement that its force causes.
  struct Reaction {
    Loads::InResidual residual;
    Vector displacement;
  };
  /// By fixed motions; empty where no residual knows them.
  const std::vector<Reaction>& reactions() const { return *reactions_; }
  /// t_p, less what pulls at supports along their tangents and at edges with a pin; empty: nothing.
  BoundaryTraction knownTraction() const;
  /// What t_p and all reactions to a contact force do there.
  Loads::InResidual inResidual(const Vector& contactForce) const;

  /// u for λ = 0 and α = 0, the loads that it is linear in (forces, then displacements given), and
  /// Rᵀ f of the free motions.
  Vector displacementOfLoads() const;
  Vector pushing() const;
  Vector rigidLoad() const;

 private:
  void setLoads();
  std::vector<Reaction> makeReactions() const;
  /// What a traction in the place of t_p does through the stabilisation.
  Loads::InResidual residualOf(const BoundaryTraction& traction) const;
  std::vector<BoundaryTraction> fixedTractions() const;
  /// What reactions to a force f - A u_D - Bᵀ λ do in the residual.
  Loads::InResidual reactionsTo(const Vector& force) const;
  /// f - Bᵀ λ with what reactions add.
  Vector wholeForce(const Vector& contactForce) const;
  /// u_D + A⁺ of such a force with what reactions add.
  Vector heldDisplacement(const Vector& force) const;
  double strainEnergy(const State& state, const Vector& displacement,
                      const Vector& contactForce, double stiffnessWork,
                      const Vector& density) const;
  double storedEnergy(const State& state, const Vector& contactForce,
                      double workOfForces) const;
  Vector clampForces(const ElasticBody::Image& image, const Vector& displacement,
                     const Vector& contactForce) const;
  /// u += R β, β = ∫ u·r of what Fix holds.
  void addFixedMotions(const Vector& force, const Vector& multiplier, Vector& u) const;

  const bem::Space* space_;
  bem::Units units_;
  std::shared_ptr<const Obstacle> obstacle_;
  std::size_t number_;
  Index firstMotion_;
  Loads loads_;  ///< with what body loads do through the stabilisation
  std::shared_ptr<const ElasticBody> elastic_;
  Vector load_{};      ///< f - A u_D
  Vector constant_{};  ///< u_D and what Fix makes of it
  std::shared_ptr<const std::vector<Reaction>> reactions_;
  double stress_ = 1;
};

/// Iterative refinement u <- u + c(u), c(u) the solution with the factor for the residual at u.
///
/// Ends if a correction is at most 1e-12 of u (rounding errors of u, or of the residual in long
/// double times the compliance of the body), after four steps, or before a correction larger than
/// half the previous one, since the factor is then too inaccurate to converge.
Vector refined(Vector u, const std::function<Vector(const Vector&)>& correction);

}  // namespace epafi::contact
