#pragma once

#include "bem/base/Error.hpp"
#include "contact/body/BodyInput.hpp"

namespace epafi::contact {

struct Holding;
class StabilisedBody;

/// The stabilised stiffness A = S - S^ is not positive definite with the γ₀ that was given.
struct IndefiniteStiffness : bem::NumericalError {
  IndefiniteStiffness(double used, double limit);
  double gamma0;       ///< what was asked for
  double limitGamma0;  ///< A is definite below
};

/// Gamma0 at which A loses its definiteness: 1 / the largest eigenvalue of (S^/gamma0,
/// S). Infinite without stabilisation.  Relative to S, the smallest eigenvalue of A is 1
/// - gamma0 / limitGamma0.                                             [P Lemma 6]
double limitGamma0(const BodyInput& input);

/// The same of a form that has the first choice of γ₀, held.
double limitGamma0(const BodyInput& input, const StabilisedBody& form,
                   const Holding& holding);

}  // namespace epafi::contact
