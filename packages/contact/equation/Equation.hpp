#pragma once

#include "contact/equation/Complementarity.hpp"
#include "contact/problem/Problem.hpp"

#include <vector>

namespace epafi::contact {

/// The nonsmooth equation at one point x = (λ, α) and the linear model of a Newton step: F and one
/// element of its generalised Jacobian.
struct Evaluation {
  Vector unknowns;     ///< x
  Vector penetration;  ///< y = c r, with Φ by its tangent
  Vector bounds;       ///< s, one per tangential

  std::vector<Complementarity> rows;  ///< one per coefficient
  std::vector<StepBound> stepBounds;  ///< slip bounds in the rows, one per tangential
  std::vector<bem::Entry> slopes;     ///< Φ', added to D
  Vector weights;                     ///< c with the tangent, see Surface::linearise
  Vector residual;                    ///< F: one per coefficient, then one per motion

  // Measures of convergence.
  Vector natural;        ///< λ - P(λ + c r), one per coefficient
  ContactStates states;  ///< without Frictionless: the sides of zero bounds
  double scaled = 0;     ///< largest natural residual or balance / Problem::stress
  double tolerance = 0;  ///< bound for `scaled`, at least the rounding error
  bool converged = false;
};

/// F(x) = 0, the condensed contact problem as a semismooth equation in stresses.
///
///   rows of λ:   λ_i - P(λ_i + c_i r_i),   c_i = 1/Σ_j (|D_ij| + |L_ij|), D_ij of i's kind
///   rows of α:   (Gᵀλ + Kα - q)_j / Σ_i |G_ij|
///
/// P: projection onto the admissible stresses, [0, ∞) or [-s_i, s_i].  Converged: each
/// row (with the bound s(λ⁺), not a step bound) over Problem::stress is at most the
/// tolerance over Problem::amplification, which makes a tolerance mean the same for all
/// bases, or at most its rounding error, for rows of λ
///
///   8 eps (c_i (|D||λ| + |d₀| + |G||α| + |Φ(λ)|)_i + |λ_i| + s_i) / stress,
///
/// without the c_i term where P(λ_i + c_i r_i) is the same for all r within that error.
///
/// Refers to the problem, which must outlive it.
class Equation {
 public:
  enum class Bound {
    Differentiated,  ///< the Jacobian contains ds/dλₙ
    Lagged           ///< it does not; s = s(λₙ⁺)                       [P sec. 7]
  };

  /// \throws bem::NumericalError if the problem holds a number that is not finite.
  Equation(const Problem& problem, Bound bound, double tolerance);

  const Problem& problem() const { return problem_; }
  Bound bound() const { return bound_; }
  /// c, one per coefficient, without Φ' of nonlinear laws.
  const Vector& weights() const { return weights_; }
  /// Σ_i |G_ij|, one per rigid motion; 1 for an empty column.
  const Vector& balanceScales() const { return balanceScales_; }
  Index size() const { return problem_.size() + problem_.rigidMotions(); }

  Evaluation at(Vector unknowns) const;
  /// With r from displacements instead of D, without the rounding error of D in the
  /// tolerance.
  Evaluation at(Vector unknowns, const Vector& penetration) const;

  /// Slip bounds in the rows at a point, for the tangentials of the problem or scaled
  /// ones.  Lagged: s(λₙ⁺).  Differentiated: the linearisation of s at p = λₙ + c rₙ > 0,
  /// evaluated at λₙ (possibly negative); s(0) for p <= 0.
  std::vector<StepBound> stepBounds(const Evaluation& e,
                                    const std::vector<Tangential>& tangentials) const;

  /// J d, J the generalised Jacobian that has these rows.
  Vector jacobianTimes(const Evaluation& at, const Vector& direction) const;
  /// Jᵀ v.
  Vector transposeTimes(const Evaluation& at, const Vector& v) const;

  /// The problem with Φ replaced by its tangent at e, so that r is linear in x.
  Problem withTangent(const Evaluation& e) const;

  /// P(λ) onto the box of the slip bounds at e; α is kept.
  Vector projected(const Evaluation& e) const;

 private:
  /// Sets the other members of e from its unknowns and r.
  void complete(Evaluation& e, Vector r, Vector magnitude) const;
  Complementarity tangentialRow(const Evaluation& e, Index t) const;
  void evaluateRows(Evaluation& e) const;
  void measure(Evaluation& e, const Vector& magnitude) const;

  const Problem& problem_;
  Bound bound_;
  double tolerance_;
  Vector weights_;
  Vector balanceScales_;
};

/// x = (λ, α) of a state, empty vectors as zero.  \pre sizes fit
Vector pack(const Problem& problem, const State& state);
State unpack(const Problem& problem, const Vector& unknowns);

/// Ψ = ½ |F|² with the Fischer-Burmeister function in place of the projection; same zeros.
double merit(const Equation& equation, const Evaluation& at);
/// ∇Ψ, continuous if the slip bound is continuously differentiable.
Vector meritGradient(const Equation& equation, const Evaluation& at);

}  // namespace epafi::contact
