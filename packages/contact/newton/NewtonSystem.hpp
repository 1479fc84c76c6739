#pragma once

#include "bem/base/Error.hpp"
#include "contact/equation/Equation.hpp"

#include <memory>

namespace epafi::contact {

/// The linear system of a Newton step has no solution that could be trusted.
struct SingularJacobian : bem::NumericalError {
  using bem::NumericalError::NumericalError;
};

/// The factorised linear system of one semismooth Newton step:  J d = b.
///
/// Rows whose coefficient's change is known (open, slipping) are eliminated.  The rest,
///
///   D_II + diag(a/(-b c)) ,   bordered by the free rigid motions G_I,
///
/// is symmetric positive definite on {G_Iᵀ d = 0} as long as no slip bound is
/// differentiated: Cholesky with the border by its Schur complement.  Otherwise LU, of
/// the same reduced size.
///
/// Where D is not formed (Flexibility::isFormed), its operator solves with D_II instead, and
/// coefficients at their bounds follow theirs there.
///
/// Rigid motions that the inactive rows do not hold (no contact yet, everything slips)
/// are left out of the step; `unheld` tells which of them the load demands.
class NewtonSystem {
 public:
  /// \throws SingularJacobian if the Jacobian is singular.
  NewtonSystem(const Equation& equation, const Evaluation& at);
  ~NewtonSystem();
  NewtonSystem(NewtonSystem&&) noexcept;

  /// J⁻¹ b, refined.
  Vector solve(const Vector& b) const;

  /// The combination v of rigid motions, in units of α, that no row holds and whose
  /// balance b demands; empty if there is none.
  Vector unheld(const Vector& b) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace epafi::contact
