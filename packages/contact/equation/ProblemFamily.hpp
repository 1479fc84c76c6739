#pragma once

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

/// What a problem's data are multiplied by.
struct Factors {
  double load = 1;      ///< tractions and prescribed displacements, not the gap
  double friction = 1;  ///< the slip bounds, >= 0
};

/// A contact problem and all its multiples:
///
///   d₀(t) = t (d₀ + g) - g,   q(t) = t q,   m times s(λₙ),
///
/// t the load factor, m the friction factor; the gap g stays where it is.
class ProblemFamily {
 public:
  /// `gap`: g per normal coefficient, see ContactProblem::gap.
  /// \throws bem::InputError if there are not as many gaps as normal coefficients.
  ProblemFamily(const Problem& problem, Vector gap);

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

 private:
  Problem original_;
  Vector load_;  // d₀ + g
  Vector gap_;
};

}  // namespace epafi::contact
