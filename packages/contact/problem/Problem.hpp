#pragma once

#include "contact/problem/Flexibility.hpp"
#include "contact/problem/Surface.hpp"
#include "contact/problem/Tangential.hpp"

#include <vector>

namespace epafi::contact {

/// The discrete contact problem condensed onto the multiplier: only numbers,
/// dimensionless.                                        [doc/theory/contact.md, In numbers]
///
///   λ = (λₙ, λₜ): `normals` normal coefficients, then one tangential per entry of
///   `tangentials`; α: the displacement's free rigid motions.
///
///   r = d₀ - D λ + G α - Φ(λ)   weighted penetration and slip
///   Gᵀ λ + K α = q           balance of the free rigid motions
///   λₙ ≥ 0,  rₙ ≤ 0,  λₙ rₙ = 0
///   |λₜ| ≤ s,  |λₜ| < s ⇒ rₜ = 0,  λₜ = ± s ⇒ ± rₜ ≥ 0,   s = s(λₙ) ≥ 0, see Tangential
///
/// Both components of a bonded place count as tangential ones, s = ∞.
///
/// D is symmetric and positive semidefinite, positive definite on {Gᵀ λ = 0} at least.
struct Problem {
  Index normals = 0;
  std::vector<Tangential> tangentials;
  Flexibility flexibility;  ///< D
  Vector offset;            ///< d₀
  Matrix rigid;             ///< G, one column per free rigid motion; may have none
  Vector rigidLoad;         ///< q
  Vector rigidStiffness;    ///< K >= 0, a diagonal, of springs; empty: there are none
  double stress = 1;        ///< size of the load, which the residual is measured by; > 0
  /// How many times more a value of λ may err than the residuals of its coefficients say.
  double amplification = 1;
  Surface surface{};  ///< Φ

  Index size() const { return normals + static_cast<Index>(tangentials.size()); }
  Index rigidMotions() const { return static_cast<Index>(rigidLoad.size()); }
  double stiffness(Index motion) const {
    return rigidStiffness.empty() ? 0 : rigidStiffness[at(motion)];
  }

  /// The same; D is shared.
  Problem copy() const;

  /// What solve() asks for before it begins.
  /// \throws bem::InputError naming what does not have the size that the others say or
  ///   refers to a coefficient that there is not; bem::NumericalError for loads that are
  ///   not finite.
  void check() const;

  bool boundDependsOnPressure() const;

  /// Slip bounds of all tangentials at a multiplier; λₙ enters through its positive part.
  Vector slipBounds(const Vector& multiplier) const;
};

/// Where an iteration starts and ends.  Empty vectors mean zero.
struct State {
  Vector multiplier;  ///< λ
  Vector rigid;       ///< α
};

/// The same problem with slip bounds given by value: a Tresca problem.
Problem withSlipBounds(const Problem& problem, const Vector& bounds);

/// r at a state.
Vector penetration(const Problem& problem, const State& state);

/// One step of a path: friction sees only what is added to an earlier slip, Δrₜ = rₜ -
/// rₜ⁰ in place of rₜ, all else the whole displacement.  Both slips carry the
/// stabilisation: with the old displacement alone a sticking contact would creep by γ (λ +
/// S u) in every step.                         [doc/theory/contact.md, Steps of a path]
Problem withSlipBefore(const Problem& problem, const Vector& slipBefore);

}  // namespace epafi::contact
