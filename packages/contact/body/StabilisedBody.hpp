#pragma once

#include "contact/body/Coupling.hpp"

#include <memory>

namespace epafi::contact {

struct Holding;
class CompressedHolding;
class MultiplierSpace;

/// What the traction t_p of a particular solution, which does not depend on u and λ, adds through
/// the residual λ + t_p + S u of the stabilisation; empty: nothing.  [doc/theory/body-loads.md]
struct ResidualTerms {
  Vector force;       ///< to f
  Vector terms;       ///< to C u - M λ
  Vector density;     ///< to ψ
  Vector compliance;  ///< g = <γ t_p, P_i> of all densities, K u - (V + G) ψ - N λ = g
};

/// A body's stiffness, held as its conditions say, and factored.
class HeldStiffness {
 public:
  virtual ~HeldStiffness() = default;

  /// (A + Σ c cᵀ)⁻¹ f on what is not clamped, zero elsewhere: every allowed rigid motion has
  /// the stiffness of its functional c, so that the sum is positive definite where A is on all
  /// other displacements.
  virtual Vector solve(const Vector& force) const = 0;
  /// L⁻¹ Cᵀ where A is formed; rows that are clamped do not count.
  virtual Matrix forward(Matrix /*rows*/) const { return {}; }
  /// Where A is not; else null.
  virtual std::shared_ptr<const CompressedHolding> compressed() const { return {}; }
};

/// What a form of the stabilisation makes of an elastic body and of the multiplier on it:
///
///   A u + Cᵀ λ = f,   C u - M λ - g in the conditions      [doc/theory/contact.md, In numbers]
///
/// All that differs from form to form is here; whoever condenses, solves or goes back to
/// the displacement needs no more.  Where S is dense makeCoupledBody makes it of any form from
/// its Coupling, where it is compressed makeCompressedBody, of forms Density and None.  A new
/// form is a name in Stabilization and what it puts into the Coupling; densities and compliance
/// of its own it gets from makeSpace and densityCompliance.
class StabilisedBody {
 public:
  virtual ~StabilisedBody() = default;

  /// The holding outlives the result.
  virtual std::shared_ptr<const HeldStiffness> held(const Holding& holding) const = 0;
  /// f - A u, free of what rounding of A would leave in the balance.
  virtual Vector residual(const Vector& force, const Vector& u) const = 0;
  /// Cᵀ, where A is formed.
  virtual Matrix coupling() const { return {}; }
  /// Cᵀ λ, with what clamps and corners feel of λ.
  virtual Vector push(const Vector& multiplier) const = 0;
  /// C u
  virtual Vector pull(const Vector& u) const = 0;
  /// C u - M λ
  virtual Vector contactTerms(const Vector& u, const Vector& multiplier) const = 0;
  Matrix multiplierMass() const { return coupling_.multiplierMass(); }  ///< M
  virtual double multiplierWork(const Vector& multiplier) const = 0;    ///< λᵀ M λ
  /// ψ of the displacement and the multiplier.
  virtual Vector density(const Vector& u, const Vector& multiplier) const = 0;
  /// 1/2 <W u, u> + 1/2 <V ψ, ψ>, ψ with the terms'.
  virtual double strainEnergy(const Vector& u, const Vector& multiplier,
                              const ResidualTerms& terms) const = 0;
  /// Of what acts inside under the multiplier's conditions.
  virtual ResidualTerms residualTerms(const MultiplierSpace& multiplier) const = 0;
  /// See ContactProblem.
  bool byDensity() const { return !coupling_.compliance.densities.empty(); }
  std::vector<bem::Vec2> meanSlacks(const Vector& multiplier, const Vector& density,
                                    const Vector& ofInside) const {
    return coupling_.meanSlacks(multiplier, density, ofInside);
  }
  /// γ on a contact element (index into MultiplierSpace::elements()), dimensionless.
  double gamma(std::size_t contactElement) const {
    return coupling_.gamma[contactElement];
  }

  /// X of A = S - X Xᵀ, which has no columns where γ cannot be too large.
  virtual Matrix subtracted() const { return {}; }
  /// The same with a γ that is factor times as large, where X has columns.
  virtual std::unique_ptr<const StabilisedBody> weakened(double /*factor*/) const {
    return nullptr;
  }

 protected:
  explicit StabilisedBody(Coupling coupling) : coupling_(std::move(coupling)) {}

  Coupling coupling_;
};

}  // namespace epafi::contact
