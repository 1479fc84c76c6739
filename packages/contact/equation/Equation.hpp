#pragma once

#include "contact/equation/Complementarity.hpp"
#include "contact/problem/Problem.hpp"

#include <vector>

namespace epafi::contact {

/// What a coefficient does: 0 open or stick, +1 closed or slip at +s, -1 slip at -s.
using ActiveSet = std::vector<signed char>;
/// How many coefficients do another thing.
int differences(const ActiveSet& a, const ActiveSet& b);

/// F at a point with one element of its generalised Jacobian: what a Newton step makes zero.
struct LinearRows {
  std::vector<Complementarity> rows;  ///< one per coefficient
  std::vector<StepBound> stepBounds;  ///< what the rows hold the shear to
  std::vector<bem::Entry> slopes{};   ///< Φ' beside D
  Vector weights{};                   ///< c of the tangent, see Surface
  Vector residual;                    ///< F: the rows' values, then the balance
};

/// The nonsmooth equation at one point x = (λ, α).
struct Evaluation {
  Vector unknowns;     ///< x
  Vector penetration;  ///< y = c r, r by the tangent of Φ
  Vector bounds;       ///< s, one per tangential
  LinearRows linear;

  // How far x is from a solution.
  Vector natural;  ///< λ - P(λ + c r), one per coefficient
  ActiveSet set;
  double scaled = 0;     ///< largest natural residual / Problem::stress
  double tolerance = 0;  ///< what `scaled` is compared with: rounding floor included
  bool converged = false;
};

/// F(x) = 0, the condensed contact problem as a semismooth equation in stresses.
///
///   rows of λ:   λ_i - P(λ_i + c_i r_i),   c_i = 1/Σ|D_ij + L_ij| (j of i's kind)
///   rows of α:   (Gᵀλ + Kα - q)_j / Σ_i |G_ij|
///
/// P projects onto what contact and friction allow, [0, ∞) or [-s_i, s_i]: Newton's method is one of
/// active sets.  Convergence is measured by the largest row of λ, of the bound s(λ) itself, times what
/// it leaves open in the values of λ, so that a tolerance means the same for all bases.  A row counts as solved when it is below the tolerance over
/// Problem::amplification or below what rounding makes of it,
///
///   8 eps c_i (|D||λ| + |d₀| + |G||α|)_i.
///
/// Refers to the problem, which must outlive it.
class Equation {
 public:
  enum class Bound {
    Differentiated,  ///< the Jacobian contains ds/dλₙ
    Lagged           ///< it does not                                   [P sec. 7]
  };

  /// \throws bem::NumericalError if the problem holds a number that is not finite.
  Equation(const Problem& problem, Bound bound, double tolerance);

  const Problem& problem() const { return problem_; }
  Bound bound() const { return bound_; }
  /// c, one per coefficient, of D and L alone.
  const Vector& weights() const { return weights_; }
  /// Σ_i |G_ij|, one per rigid motion; 1 for an empty column.
  const Vector& balanceScales() const { return balanceScales_; }
  Index size() const { return problem_.size() + problem_.rigidMotions(); }

  Evaluation at(Vector unknowns) const;
  /// Where r is known by another way than D, whose rounding is no part of the floor.
  Evaluation at(Vector unknowns, const Vector& penetration) const;

  /// The rows' bounds at a point; `tangentials` are the problem's, or of other strengths.
  /// A differentiated bound follows the sets of normal coefficients: s(λₙ) of those where
  /// λₙ + c rₙ > 0, whatever λₙ has for a sign, nothing of the others.  A lagged one is s(λₙ⁺).
  std::vector<StepBound> stepBounds(const Evaluation& e,
                                    const std::vector<Tangential>& tangentials) const;

  /// J d, J the generalised Jacobian that has these rows.
  Vector jacobianTimes(const LinearRows& at, const Vector& direction) const;
  /// Jᵀ v.
  Vector transposeTimes(const LinearRows& at, const Vector& v) const;

  /// The problem with Φ replaced by the tangent at e, so that all of r is linear.
  Problem withTangent(const Evaluation& e) const;

  /// P(λ) onto the box of the slip bounds at e; α is kept.
  Vector projected(const Evaluation& e) const;

 private:
  /// All else from unknowns and r.
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

/// x = (λ, α); what is empty becomes zero, an iterate of another size is an error of the
/// caller.
Vector pack(const Problem& problem, const State& state);
State unpack(const Problem& problem, const Vector& unknowns);

}  // namespace epafi::contact
