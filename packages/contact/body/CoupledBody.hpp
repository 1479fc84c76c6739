#pragma once

#include "bem/base/Error.hpp"
#include "contact/body/BodyInput.hpp"
#include "contact/body/Holding.hpp"
#include "contact/body/StabilisedBody.hpp"

namespace epafi::contact {

/// The stabilised stiffness A = S - S^ is not positive definite with the γ₀ that was given.
struct IndefiniteStiffness : bem::NumericalError {
  IndefiniteStiffness(double used, double limit);
  double gamma0;       ///< what was asked for
  double limitGamma0;  ///< A is definite below
};

/// A body with dense stiffness: all forms of the stabilisation, by their Coupling.  γ₀ becomes smaller
/// if the default is too large.
/// \pre input.stiffness is formed  \throws IndefiniteStiffness if a given γ₀ is too large
std::unique_ptr<const StabilisedBody> makeCoupledBody(
    const BodyInput& input, const MultiplierSpace& multiplier,
    const std::shared_ptr<const Holding>& holding);

/// γ₀ at which A loses its definiteness: 1 / the largest eigenvalue of (S^/γ₀, S).  Infinite without
/// S^.  Relative to S, the smallest eigenvalue of A is 1 - γ₀ / limitGamma0.      [P Lemma 6]
double limitGamma0(const BodyInput& input);

}  // namespace epafi::contact
