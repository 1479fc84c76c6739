#pragma once

#include "contact/equation/Equation.hpp"
#include "contact/system/ContactSystem.hpp"

namespace epafi::contact {

/// Start of Newton's method in the next step of a path: the last solution, or the extrapolation
/// of the last two by the load,
///
///   x = x_k + f (x_k - x_{k-1}),   f = <ℓ - ℓ_k, ℓ_k - ℓ_{k-1}> / |ℓ_k - ℓ_{k-1}|²,   f > 0,
///
/// ℓ = (c d₀, q / Σ|G|) the load as stresses, without previous slip, x₀ = 0.  Chooses the one in
/// which fewer coefficients change their state from the last solution.
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
  ContactStates states_;
};

}  // namespace epafi::contact
