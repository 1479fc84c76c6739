#pragma once

#include "contact/body/RigidConstraints.hpp"
#include "contact/body/StabilisedBody.hpp"
#include "contact/problem/Problem.hpp"

#include <functional>

namespace epafi::contact {

/// How a body is loaded and held.
struct Holding {
  Loads loads;
  RigidModes modes;
  RigidConstraints rigid;
  Vector means{};  ///< see meansOf
};

/// \throws bem::InputError, see makeLoads, makeRigidConstraints.
Holding makeHolding(const bem::Space& space, const Conditions& conditions,
                    bem::Units units);

/// A body among those of a contact problem: its stiffness factored, how it answers loads
/// and contact forces, and its free rigid motions.
///
///   A u = f - Cᵀ λ on what is neither clamped nor fixed,   u = u_D + A⁺ (f - Cᵀ λ) + R α
class ElasticBody {
 public:
  /// Both outlive the body.  \throws bem::NumericalError if A is not definite.
  ElasticBody(const StabilisedBody& form, const Holding& holding);

  /// The same body under other loads and prescribed displacements; A's factor is shared.
  /// The holding clamps and fixes the same, and outlives the body.
  ElasticBody under(const Holding& holding) const;

  Index freeMotions() const { return holding_->rigid.free(); }
  /// R α of their sizes.
  Vector moved(const double* motions) const;

  /// What the body adds to a condensed problem through a Cᵀ:
  struct Response {
    Matrix half;       ///< L⁻¹ Cᵀ:  C A⁻¹ Cᵀ is its Gram matrix ...
    Matrix motions;    ///< ... less this times its transpose: C R, fixed, then free
    Vector offset;     ///< C u for λ = 0, α = 0
    Vector rigidLoad;  ///< Rᵀ f of the free motions
  };
  Response response(Matrix coupling) const;
  /// The same without `half`, from C u.
  Response response(const std::function<Vector(const Vector& u)>& pull) const;
  /// Where no stiffness is formed; else null.
  std::shared_ptr<const CompressedHolding> compressed() const {
    return stiffness_->compressed();
  }

  /// u for λ = 0, α = 0, and Rᵀ f of the free motions: what loads make of a response.
  Vector unpushed() const;
  /// The loads that it is linear in: forces, then displacements given.
  Vector pushing() const;
  Vector rigidLoad() const;

  /// u under the contact forces Cᵀ λ, the free motions' sizes from `motions` on; refined,
  /// so that the equations hold to the rounding of u.
  Vector displacement(const Vector& contactForce, const double* motions) const;

  /// A u + Cᵀ λ - f on prescribed displacements, zero elsewhere, see
  /// ContactProblem::clampForces.
  Vector clampForces(const Vector& contactForce, const Vector& displacement) const;

  /// (A u + Cᵀ λ - f) · v, see ContactProblem::clampWork.
  Vector clampWork(const Vector& contactForce, const Vector& displacement) const;

  /// See ContactProblem::fixedReactions.
  Vector fixedReactions(const Vector& contactForce) const;

 private:
  Vector respond(Vector force) const;

  const StabilisedBody* form_;
  const Holding* holding_;
  Vector load_;      ///< f - A u_D
  Vector constant_;  ///< u_D and what Fix makes of it
  std::shared_ptr<const HeldStiffness> stiffness_;
};

/// The problem that all bodies make together:
///
///   D = Σ_b C_b A_b⁺ C_bᵀ + M,   d₀ = Σ_b C_b u_b,   G = (C_b R_b)_b,   q = (R_bᵀ f_b)_b
///
/// `multiplierMass` is M.  Bounds, gaps and normals are the contacts' business.
Problem condense(Matrix multiplierMass, const std::vector<ElasticBody::Response>& bodies);
/// The same where D is given.
Problem condense(Flexibility flexibility,
                 const std::vector<ElasticBody::Response>& bodies);

}  // namespace epafi::contact
