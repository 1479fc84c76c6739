#pragma once

#include "contact/equation/Equation.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace epafi::contact {

/// Factored linear system of one semismooth Newton step, J d = b, after elimination of the
/// coefficients that their own rows determine (open, slipping):
///
///   known      d_i = b_i + f_i d_j,   j: the pressure on which the bound of i depends
///   inactive   Σ_j D_ij d_j - Σ_j G_ij α_j = b_i / c_i
///   balance    Σ_i G_ij d_i + K_j α_j = b_j
///
/// D includes Φ'.  Rigid motions, scaled to size one, are split into combinations that
/// the inactive rows or springs constrain and those that they do not (no contact, or all
/// slips).  The latter are left out of the step; unheld() returns the one that the load
/// requires.
class NewtonSystem {
 public:
  /// All arguments must outlive this.
  /// \throws SingularJacobian if the Jacobian is singular
  NewtonSystem(const Equation& equation, const Evaluation& at);

  /// J⁻¹ b, refined.  \throws SingularJacobian
  Vector solve(const Vector& b) const;

  /// The rigid motion v, amplitudes like α, that no row or spring constrains and whose
  /// balance b requires; empty: none.
  Vector unheld(const Vector& b) const { return demanded(loose_, b); }
  /// Likewise, the motion that only springs constrain.
  Vector unpressed(const Vector& b) const { return demanded(unpressed_, b); }

 private:
  bool isKnown(Index i) const { return rows_.rows[at(i)].penetration == 0; }
  /// j and f of a known coefficient; f = 0: none.
  std::pair<Index, double> followed(Index i) const;
  void splitMotions();
  Vector demanded(const Matrix& combinations, const Vector& b) const;
  /// System for the inactive coefficients and held motions.
  Flexibility::Operator::System reduced() const;
  /// d of known coefficients without the terms of inactive ones; zero for the latter.
  Vector knownChanges(const Vector& b) const;
  /// Right-hand side of the balance of each scaled motion.
  Vector balance(const Vector& b) const;
  /// (d, α) of J d = b, not refined.
  Vector byFactor(const Vector& b) const;

  const Equation& equation_;
  const Evaluation& rows_;
  const Problem& problem_;
  std::vector<Index> inactive_;  ///< the coefficients that are solved for
  Vector motionScale_;           ///< scales each rigid motion to size one
  Matrix held_;       ///< combinations of scaled motions that rows or springs constrain
  Matrix loose_;      ///< orthonormal ones that they do not
  Matrix unpressed_;  ///< ... that the rows do not; empty without springs
  std::unique_ptr<const Flexibility::Operator::Factor> factor_;
};

}  // namespace epafi::contact
