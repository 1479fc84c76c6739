#pragma once

#include "contact/problem/ContactState.hpp"
#include "contact/problem/Flexibility.hpp"
#include "contact/problem/Surface.hpp"
#include "contact/problem/Tangential.hpp"

#include <vector>

namespace epafi::contact {

/// The discrete contact problem condensed onto the multiplier: only numbers,
/// dimensionless.                                        [doc/theory/contact.md, In numbers]
///
///   λ = (λₙ, λₜ): `normals` normal coefficients, then one tangential per entry of
///   `tangentials`; α: amplitudes of the free rigid motions.
///
///   r = d₀ - D λ + G α - Φ(λ)   weighted penetration and slip
///   Gᵀ λ + K α = q              balance of the free rigid motions
///   λₙ ≥ 0,  rₙ ≤ 0,  λₙ rₙ = 0
///   |λₜ| ≤ s,  |λₜ| < s ⇒ rₜ = 0,  λₜ = ± s ⇒ ± rₜ ≥ 0,   s = s(λₙ) ≥ 0, see Tangential
///
/// Both components of a bonded contact are tangential coefficients with s = ∞.
///
/// D is symmetric and positive semidefinite, positive definite on {Gᵀ λ = 0} at least.
struct Problem {
  Index normals = 0;
  std::vector<Tangential> tangentials;
  Flexibility flexibility;  ///< D
  Vector offset;            ///< d₀
  Matrix rigid;             ///< G, size() x number of free rigid motions, possibly 0
  Vector rigidLoad;         ///< q
  Vector rigidStiffness;    ///< diagonal of K >= 0, the springs; empty: zero
  double stress = 1;        ///< size of the load, unit of the scaled residual; > 0
  /// Ratio of the error of values of λ to residuals of its coefficients, see
  /// MultiplierBasis::amplification.
  double amplification = 1;
  Surface surface{};  ///< Φ

  Index size() const { return normals + static_cast<Index>(tangentials.size()); }
  Index rigidMotions() const { return static_cast<Index>(rigidLoad.size()); }
  double stiffness(Index motion) const {
    return rigidStiffness.empty() ? 0 : rigidStiffness[at(motion)];
  }

  /// A copy that shares D.
  Problem copy() const;

  /// Checks sizes and values; solve() calls it.
  /// \throws bem::InputError naming the member whose size or index does not fit
  /// \throws bem::NumericalError for data that are not finite, stress <= 0 or a negative
  /// spring
  void check() const;

  /// Has any tangential coefficient a bound > 0 that depends on the pressure?
  bool boundDependsOnPressure() const;

  /// Slip bounds s(λₙ⁺), one per tangential coefficient; empty multiplier: zero.
  Vector slipBounds(const Vector& multiplier) const;
};

/// Start or result of an iteration.  Empty vectors mean zero.
struct State {
  Vector multiplier;  ///< λ
  Vector rigid;       ///< α
};

/// The problem with given slip bounds, one per tangential coefficient: a Tresca problem.
Problem withSlipBounds(const Problem& problem, const Vector& bounds);

/// r at a state, one per coefficient.
Vector penetration(const Problem& problem, const State& state);

/// Problem of one step of a path: the friction law gets the slip increment rₜ - rₜ⁰,
/// rₜ⁰ = `slipBefore`.  Both slips contain the stabilisation; with displacements alone, a
/// sticking contact would creep by γ (λ + S u) in every step.
///                                              [doc/theory/contact.md, Steps of a path]
Problem withSlipBefore(const Problem& problem, const Vector& slipBefore);

}  // namespace epafi::contact
