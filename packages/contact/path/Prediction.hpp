#pragma once

#include "contact/equation/Equation.hpp"
#include "contact/system/ContactSystem.hpp"

namespace epafi::contact {

/// Where Newton's method begins in the next step of a path: the last solution, or on the line
/// through the last two as far as the load goes on along it,
///
///   x = x_k + f (x_k - x_{k-1}),   f = <ℓ - ℓ_k, ℓ_k - ℓ_{k-1}> / |ℓ_k - ℓ_{k-1}|²,   f > 0,
///
/// ℓ = (c d₀, q / Σ|G|) the load as stresses, without what slipped before, x₀ = 0.  Of the two
/// the one in which fewer coefficients leave the last solution's sets.
class Prediction {
 public:
  /// \param atZero the problem at t = 0
  explicit Prediction(const ContactSystem& atZero) : load_(loadOf(atZero)) {}

  /// Adds a solved step.
  void add(const ContactSystem& step, const State& solved);

  /// Empty vectors before the first step.
  State start(const ContactSystem& step) const;
  const State& last() const { return last_; }

 private:
  static Vector loadOf(const ContactSystem& step);

  State last_;
  State change_;  ///< from the solution before to the last one
  Vector load_;
  Vector loadChange_;
  ActiveSet set_;
};

}  // namespace epafi::contact
