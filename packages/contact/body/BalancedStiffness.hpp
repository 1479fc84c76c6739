#pragma once

#include "contact/body/Coupling.hpp"
#include "contact/body/Loads.hpp"

namespace epafi::contact {

/// A = S - S^ as an operator that leaves no rounding in the balance of forces.
///
///   A = Pᵀ (S - S^) P,   P u = u - Σ_k r_k <u, r_k> / <r_k, r_k>,  <.,.>: L2(boundary)
///
/// In exact arithmetic rigid motions r are in the kernel of S and of S^, and P changes
/// nothing.  The entries of S know it to ε |S| only; that is a force of ε |S| |u|, as
/// large as the load times 1e-10 for a beam of 1:100 (u is 5000 times the load) or for nu
/// = 0.4999999 (|S| is 5e6 times Young's modulus).  Sums have twice a double's digits for
/// the same reason.
class BalancedStiffness {
 public:
  /// Refers to the stiffness, which must outlive it.
  BalancedStiffness(const bem::SteklovPoincare& stiffness, RigidModes modes,
                    const Coupling& coupling);

  /// f - A u
  Vector residual(const Vector& force, const Vector& u) const;

  /// uᵀ S u, to the rounding of what deforms the body: not of S's large entries where
  /// nu -> 1/2 nor of a rigid motion in u.
  double stiffnessWork(const Vector& u) const;

 private:
  using Extended = std::vector<long double>;

  Extended withoutMotions(const Vector& u) const;
  Extended balanced(Extended forces) const;
  Extended stiffnessTimes(const Extended& u) const;
  void subtractStabilisation(const Extended& u, Extended& forces) const;

  const bem::SteklovPoincare* stiffness_;
  RigidModes modes_;
  Vector squares_;  ///< <r_k, r_k>
  std::shared_ptr<const bem::TractionRows> tractions_;
  Vector gamma_;
};

}  // namespace epafi::contact
