#pragma once

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

/// Factors of the data of a problem.
struct Factors {
  double load = 1;       ///< tractions and prescribed displacements, not the gap
  double friction = 1;   ///< the slip bounds, >= 0
  double increment = 1;  ///< fraction of a step of a path
};

/// A contact problem with parameters:
///
///   d₀(t, s) = t (d₀ + g) - g - (1 - s) Δd₀,   q(t, s) = t q - (1 - s) Δq,   bounds m s(λₙ),
///
/// t: load factor, m: friction factor, g: the gap, which is not scaled.  s: increment in
/// a step of a path, Δ: change in this step, of the gap too; s = 0 is the previous step,
/// s = 1 this one.  Outside a path Δ = 0.
class ProblemFamily {
 public:
  /// \param gap g, one per normal coefficient, see ContactSystem::gap
  /// \throws bem::InputError if there are not as many gaps as normal coefficients.
  ProblemFamily(const Problem& problem, Vector gap);

  /// A step of a path.
  /// \param before the problem with the loads of the previous step and the same previous
  /// slip
  ///   (ContactSystem::under)
  ProblemFamily(const Problem& problem, Vector gap, const Problem& before);
  bool isStep() const { return !change_.empty(); }

  /// The problem with all factors 1.
  const Problem& original() const { return original_; }

  /// \throws bem::InputError for a factor that is not finite or a negative friction
  /// factor.
  Problem at(const Factors& factors) const;

  /// ∂F/∂t at a point, with the element of the generalised derivative in the Jacobian's
  /// rows.
  /// \pre the equation is of a problem of this family
  Vector loadDerivative(const Equation& equation, const Evaluation& e) const;

  /// ∂F/∂m, likewise.
  Vector frictionDerivative(const Equation& equation, const Evaluation& e) const;

  /// ∂F/∂s, likewise.  \pre isStep()
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
