#pragma once

#include "contact/equation/Equation.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace epafi::contact {

class FactorMemory;

/// The factorised linear system of one semismooth Newton step, J d = b, without the coefficients
/// whose change is known from their own rows (open, slipping):
///
///   known      d_i = b_i + f_i d_j,   j: the pressure that the bound of i follows
///   inactive   Σ_j D_ij d_j - Σ_j G_ij α_j = b_i / c_i
///   balance    Σ_i G_ij d_i + K_j α_j = b_j
///
/// Factored by D, from a memory where there is one and as far as refinement then converges.  Rigid motions, measured in units in which each has size
/// one, are split into the combinations that the inactive rows or springs hold and those that they do not
/// (no contact yet, everything slips).  The latter are left out of the step; `unheld` tells which
/// of them the load demands.
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
  Vector unheld(const Vector& b) const { return demanded(loose_, b); }
  /// Likewise of those that springs alone hold.
  Vector unpressed(const Vector& b) const { return demanded(unpressed_, b); }

 private:
  bool isKnown(Index i) const { return rows_.rows[at(i)].penetration == 0; }
  /// j and f of a known change, f = 0: of none.
  std::pair<Index, double> followed(Index i) const;
  void splitMotions();
  Vector demanded(const Matrix& combinations, const Vector& b) const;
  /// What D factors.
  Flexibility::Operator::System reduced() const;
  /// The changes that do not depend on the inactive ones; zero elsewhere.
  Vector knownChanges(const Vector& b) const;
  /// What b demands of the balance of each scaled motion.
  Vector balance(const Vector& b) const;
  /// d, then α, of J d = b, as well as the factor can.
  Vector byFactor(const Vector& b) const;
  /// Adds to d what the factor makes of what d leaves of b; returns the largest change.
  double refine(const Vector& b, Vector& d) const;

  const Equation& equation_;
  const LinearRows& rows_;
  const Problem& problem_;
  std::vector<Index> inactive_;  ///< the coefficients that are solved for
  Vector motionScale_;           ///< gives each rigid motion size one
  Matrix
      held_;  ///< orthonormal combinations of scaled motions that the inactive rows hold
  Matrix loose_;      ///< ... and that they do not
  Matrix unpressed_;  ///< where there are springs: that the rows do not hold
  /// From a memory, until refinement with it fails.
  mutable std::unique_ptr<const Flexibility::Operator::Factor> factor_;
  mutable bool isKept_ = false;
};

}  // namespace epafi::contact
