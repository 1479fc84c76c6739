#pragma once

#include "bem/base/Matrix.hpp"
#include "contact/law/FrictionLaw.hpp"

#include <vector>

namespace epafi::contact {

using bem::Index;
using bem::Matrix;
using bem::Vector;

/// A tangential coefficient of the multiplier and what limits it.
struct Tangential {
  Index normal = 0;  ///< the normal coefficient at the same place
  const FrictionLaw* law = nullptr;
  double strength = 0;  ///< threshold or coefficient, dimensionless, >= 0
};

/// The discrete contact problem condensed onto the multiplier: only numbers,
/// dimensionless.
///
///   λ = (λₙ, λₜ): `normals` normal coefficients, then one tangential per entry of
///   `tangentials`; α: the displacement's free rigid motions.
///
///   r = d₀ - D λ + G α            weighted penetration and slip [design.md 4.1] Gᵀ λ = q
///   balance of the free rigid motions λₙ ≥ 0,  rₙ ≤ 0,  λₙ rₙ = 0 |λₜ| ≤ s,  |λₜ| < s ⇒
///   rₜ = 0,  λₜ = ± s ⇒ ± rₜ ≥ 0,   s = law.slipBound(λₙ, strength)
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

  /// Slip bounds of all tangentials at a multiplier; λₙ enters through its positive part.
  Vector slipBounds(const Vector& multiplier) const;
};

/// The same problem with slip bounds given by value: a Tresca problem.
Problem withSlipBounds(const Problem& problem, const Vector& bounds);

/// Where an iteration starts and ends.  Empty vectors mean zero.
struct State {
  Vector multiplier;  ///< λ
  Vector rigid;       ///< α
};

}  // namespace epafi::contact
