#pragma once

#include "contact/newton/Factoring.hpp"

namespace epafi::contact {

class FactorMemory;

/// The factorised linear system of one semismooth Newton step:  J d = b, see Reduction.
///
/// Factored by D's operator where D is not formed and bounds let it; by a factor from a memory,
/// where there is one, as far as refinement then converges; else by D's entries.
///
/// Rigid motions that the inactive rows do not hold (no contact yet, everything slips)
/// are left out of the step; `unheld` tells which of them the load demands.
class NewtonSystem {
 public:
  /// `memory`: the factor of systems before this one; null: there is none.  All outlive this.
  /// \throws SingularJacobian if the Jacobian is singular.
  NewtonSystem(const Equation& equation, const LinearRows& at,
               FactorMemory* memory = nullptr);

  /// J⁻¹ b, refined.  \throws SingularJacobian
  Vector solve(const Vector& b) const;

  /// The combination v of rigid motions, in units of α, that no row holds and whose
  /// balance b demands; empty if there is none.
  Vector unheld(const Vector& b) const;

 private:
  /// Adds to d what a factor makes of what d leaves of b; returns the largest change.
  double refine(const Factoring& factoring, const Vector& b, Vector& d) const;

  const Reduction reduction_;
  std::unique_ptr<const Factoring> byOperator_;
  std::unique_ptr<const Factoring> byKept_;
  /// Also made once the kept factor has failed.
  mutable std::unique_ptr<const Factoring> byEntries_;
};

}  // namespace epafi::contact
