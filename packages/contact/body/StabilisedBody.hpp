#pragma once

#include "contact/body/Coupling.hpp"

#include <memory>
#include <utility>

namespace epafi::contact {

struct Holding;

/// Discrete equations of an elastic body and its multiplier for a form of the stabilisation, with A
/// factored under the Dirichlet conditions of the body:
///
///   A u + Bᵀ λ = f,   B u - M λ - g in the conditions      [doc/theory/contact.md, In numbers]
///
///   B = C - Gᵀ Rᵀ,   M - Gᵀ X G in M's place with Form Density,   see Coupling
///
/// What differs is how S is held, and with it R, X and the factor: for dense S makeCoupledBody
/// supports all forms, for compressed S CompressedBody those that do not evaluate S u.
class StabilisedBody {
 public:
  virtual ~StabilisedBody() = default;

  /// (A + Σ c cᵀ)⁻¹ f, zero on clamped unknowns; c: functionals of the allowed rigid motions, so
  /// that the sum is positive definite if A is positive definite on all other displacements.
  virtual Vector solve(const Vector& force) const = 0;
  /// Is A formed?  Else solve() is refined by its own product.
  virtual bool isFormed() const = 0;
  /// If A is formed: Bᵀ, M, and L⁻¹ Cᵀ with the factor L, where clamped rows are ignored.
  virtual Matrix coupling() const { return {}; }
  virtual Matrix multiplierMass() const { return {}; }
  virtual Matrix forward(Matrix /*rows*/) const { return {}; }

  /// f - A u, balanced up to rounding, see BalancedStiffness.
  virtual Vector residual(const Vector& force, const Vector& u) const = 0;
  /// ψ of the displacement and the multiplier.
  virtual Vector density(const Vector& u, const Vector& multiplier) const = 0;
  /// 1/2 <W u, u> + 1/2 <V ψ, ψ>, ψ including inside.density.
  virtual double strainEnergy(const Vector& u, const Vector& multiplier,
                              const Loads::OfInside& inside) const = 0;

  /// Bᵀ λ, including forces on clamps and corners.
  Vector applyTranspose(const Vector& multiplier) const;
  /// B u
  Vector apply(const Vector& u) const;
  /// M λ
  Vector massTimes(const Vector& multiplier) const;
  /// Sets what body loads do through the stabilisation.
  void setResidual(const MultiplierSpace& multiplier, Loads::OfInside& inside) const;
  const Coupling& local() const { return coupling_; }

 protected:
  StabilisedBody(const bem::Space& space, std::shared_ptr<const Holding> holding,
                 Coupling coupling)
      : space_(space), holding_(std::move(holding)), coupling_(std::move(coupling)) {}

  /// Rᵀ u, R w and, with densities, X w.
  virtual Vector tractionsOf(const Vector& u) const = 0;
  virtual Vector forcesOf(const Vector& w) const = 0;
  virtual Vector responsesTo(const Vector& w) const = 0;
  /// (V + G)⁻¹ g, and K' of it.
  virtual std::pair<Vector, Vector> answerTo(const Vector& compliance) const = 0;

  const bem::Space& space_;
  std::shared_ptr<const Holding> holding_;
  Coupling coupling_;
};

}  // namespace epafi::contact
