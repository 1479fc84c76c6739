#pragma once

#include "contact/body/Coupling.hpp"

#include <memory>

namespace epafi::contact {

struct Holding;
class CompressedHolding;
class MultiplierSpace;

/// Terms of the traction t_p of a particular solution in the residual λ + t_p + S u of the
/// stabilisation, independent of u and λ; empty: zero.               [doc/theory/body-loads.md]
struct ResidualTerms {
  Vector force;       ///< to f
  Vector terms;       ///< to C u - M λ
  Vector density;     ///< to ψ
  Vector compliance;  ///< g = <γ t_p, P_i> of all densities, K u - (V + G) ψ - N λ = g
};

/// Factored stiffness of a body with its Dirichlet conditions.
class HeldStiffness {
 public:
  virtual ~HeldStiffness() = default;

  /// (A + Σ c cᵀ)⁻¹ f, zero on clamped unknowns; c: functionals of the allowed rigid motions, so
  /// that the sum is positive definite if A is positive definite on all other displacements.
  virtual Vector solve(const Vector& force) const = 0;
  /// L⁻¹ Cᵀ if A is formed; clamped rows are ignored.
  virtual Matrix forward(Matrix /*rows*/) const { return {}; }
  /// Null if A is formed.
  virtual std::shared_ptr<const CompressedHolding> compressed() const { return {}; }
};

/// Discrete equations of an elastic body and its multiplier for a form of the stabilisation:
///
///   A u + Cᵀ λ = f,   C u - M λ - g in the conditions      [doc/theory/contact.md, In numbers]
///
/// All differences between forms are in this interface.  For dense S makeCoupledBody supports all
/// forms, for compressed S makeCompressedBody the forms Density and None.  A new form needs a
/// name in Stabilization and its Coupling; makeSpace and densityCompliance give it additional
/// densities and a compliance.
class StabilisedBody {
 public:
  virtual ~StabilisedBody() = default;

  /// Factors the stiffness.  The result refers to the holding.
  virtual std::shared_ptr<const HeldStiffness> held(const Holding& holding) const = 0;
  /// f - A u, balanced up to rounding, see BalancedStiffness.
  virtual Vector residual(const Vector& force, const Vector& u) const = 0;
  /// Cᵀ, if A is formed.
  virtual Matrix coupling() const { return {}; }
  /// Cᵀ λ, including forces on clamps and corners.
  virtual Vector push(const Vector& multiplier) const = 0;
  /// C u
  virtual Vector pull(const Vector& u) const = 0;
  /// C u - M λ
  virtual Vector contactTerms(const Vector& u, const Vector& multiplier) const = 0;
  Matrix multiplierMass() const { return coupling_.multiplierMass(); }  ///< M
  virtual double multiplierWork(const Vector& multiplier) const = 0;    ///< λᵀ M λ
  /// ψ of the displacement and the multiplier.
  virtual Vector density(const Vector& u, const Vector& multiplier) const = 0;
  /// 1/2 <W u, u> + 1/2 <V ψ, ψ>, ψ including terms.density.
  virtual double strainEnergy(const Vector& u, const Vector& multiplier,
                              const ResidualTerms& terms) const = 0;
  /// Terms of the body loads in the conditions of the multiplier.
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

  /// X of A = S - X Xᵀ; without columns if A is definite for all γ.
  virtual Matrix subtracted() const { return {}; }
  /// The body with factor times γ; null if X has no columns.
  virtual std::unique_ptr<const StabilisedBody> weakened(double /*factor*/) const {
    return nullptr;
  }

 protected:
  explicit StabilisedBody(Coupling coupling) : coupling_(std::move(coupling)) {}

  Coupling coupling_;
};

}  // namespace epafi::contact
