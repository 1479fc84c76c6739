#pragma once

#include "contact/problem/Tangential.hpp"

#include <vector>

namespace epafi::contact {

using bem::Matrix;

/// The discrete contact problem condensed onto the multiplier: only numbers,
/// dimensionless.
///
///   λ = (λₙ, λₜ): `normals` normal coefficients, then one tangential per entry of
///   `tangentials`; α: the displacement's free rigid motions.
///
///   r = d₀ - D λ + G α            weighted penetration and slip [design.md 4.1] Gᵀ λ = q
///   balance of the free rigid motions λₙ ≥ 0,  rₙ ≤ 0,  λₙ rₙ = 0 |λₜ| ≤ s,  |λₜ| < s ⇒
///   rₜ = 0,  λₜ = ± s ⇒ ± rₜ ≥ 0,   s = s(λₙ) >= 0, see
///   Tangential
///
/// D is symmetric and positive semidefinite, positive definite on {Gᵀ λ = 0} at least.
struct Problem {
  Index normals = 0;
  std::vector<Tangential> tangentials;
  Matrix flexibility;  ///< D, full
  Vector offset;       ///< d₀
  Matrix rigid;        ///< G, one column per free rigid motion; may have none
  Vector rigidLoad;    ///< q
  double stress = 1;   ///< size of the load, which the residual is measured by; > 0

  Index size() const { return normals + static_cast<Index>(tangentials.size()); }
  Index rigidMotions() const { return static_cast<Index>(rigidLoad.size()); }
  bool boundDependsOnPressure() const;
  bool boundsAreCoupled() const;  ///< does one follow several pressures?

  /// Slip bounds of all tangentials at a multiplier; λₙ enters through its positive part.
  Vector slipBounds(const Vector& multiplier) const;
};

/// The same problem with each slip bound following its own pressure alone.
Problem withUncoupledBounds(const Problem& problem);

/// The same problem with slip bounds given by value: a Tresca problem.
Problem withSlipBounds(const Problem& problem, const Vector& bounds);

/// Where an iteration starts and ends.  Empty vectors mean zero.
struct State {
  Vector multiplier;  ///< λ
  Vector rigid;       ///< α
};

}  // namespace epafi::contact
