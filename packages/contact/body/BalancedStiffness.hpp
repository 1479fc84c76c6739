#pragma once

#include "bem/operators/SteklovPoincare.hpp"
#include "bem/tractions/TractionRows.hpp"
#include "contact/body/Loads.hpp"

namespace epafi::contact {

/// Operator A = S - S^ whose rounding errors do not affect the balance of forces.
///
///   A = Pᵀ (S - S^) P,   P u = u - Σ_k r_k <u, r_k> / <r_k, r_k>,  <.,.>: L2(boundary)
///
/// In exact arithmetic rigid motions r are in the kernels of S and S^, and P changes nothing.
/// The computed S satisfies this up to ε |S| only, an error of ε |S| |u| in the forces: 1e-10
/// of the load for a beam of 1:100 (u is 5000 times the load) or for nu = 0.4999999 (|S| is
/// 5e6 times Young's modulus).  For the same reason sums are computed with twice the digits
/// of a double.
class BalancedStiffness {
 public:
  /// Refers to the stiffness.  \param tractions and γ of contact elements; null: S^ = 0
  BalancedStiffness(const bem::SteklovPoincare& stiffness, RigidModes modes,
                    std::shared_ptr<const bem::TractionRows> tractions, Vector gamma);

  /// f - A u
  Vector residual(const Vector& force, const Vector& u) const;

  /// uᵀ S u; the rounding error is relative to the result, neither to large entries of S as
  /// nu -> 1/2 nor to a rigid motion in u.
  double stiffnessWork(const Vector& u) const;

 private:
  using Extended = std::vector<long double>;

  Extended withoutMotions(const Vector& u) const;
  Extended balanced(Extended forces) const;
  Extended stiffnessTimes(const Extended& u) const;
  void subtractStabilisation(const Extended& u, Extended& forces) const;

  const bem::SteklovPoincare* stiffness_;
  RigidModes modes_;
  Vector squares_;                                      ///< <r_k, r_k>
  std::shared_ptr<const bem::TractionRows> tractions_;  ///< null: no S^
  Vector gamma_;
};

}  // namespace epafi::contact
