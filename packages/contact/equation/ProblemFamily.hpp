#pragma once

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

/// What a problem's data are multiplied by.
struct Factors {
  double load = 1;       ///< tractions and prescribed displacements, not the gap
  double friction = 1;   ///< the slip bounds, >= 0
  double increment = 1;  ///< the part of a step of a path that is done
};

/// A contact problem and all its multiples:
///
///   d₀(t, s) = t (d₀ + g) - g - (1 - s) Δd₀,   q(t, s) = t q - (1 - s) Δq,   m times s(λₙ),
///
/// t the load factor, m the friction factor; the gap g stays where it is.  s the increment of
/// a step of a path: Δ is what the step adds, gaps included, so that s = 0 is the step before
/// and s = 1 this one; without a step before there is none.
class ProblemFamily {
 public:
  /// `gap`: g per normal coefficient, see ContactProblem::gap.
  /// \throws bem::InputError if there are not as many gaps as normal coefficients.
  ProblemFamily(const Problem& problem, Vector gap);

  /// A step of a path; `before`: the same under the loads of the step before, both with the
  /// same slip before (ContactSystem::under).
  ProblemFamily(const Problem& problem, Vector gap, const Problem& before);
  bool isStep() const { return !change_.empty(); }

  /// The problem itself, factors one.
  const Problem& original() const { return original_; }

  /// \throws bem::InputError for a factor that is not finite or a negative friction
  /// factor.
  Problem at(const Factors& factors) const;

  /// ∂F/∂t at a point: exact where F is differentiable, elsewhere of the same element of
  /// the generalised derivative as the Jacobian's rows.  \pre the equation is of one of
  /// this family's problems.
  Vector loadDerivative(const Equation& equation, const Evaluation& e) const;

  /// ∂F/∂m likewise.
  Vector frictionDerivative(const Equation& equation, const Evaluation& e) const;

  /// ∂F/∂s likewise.  \pre isStep()
  Vector incrementDerivative(const Equation& equation, const Evaluation& e) const;

 private:
  Vector derivative(const Equation& equation, const Evaluation& e, const Vector& offset,
                    const Vector& rigidLoad) const;

  Problem original_;
  Vector load_;  // d₀ + g
  Vector gap_;
  Vector change_;       // Δd₀; empty: not a step
  Vector rigidChange_;  // Δq
};

}  // namespace epafi::contact
