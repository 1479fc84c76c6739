#pragma once

#include "bem/base/Error.hpp"
#include "contact/problem/Problem.hpp"

namespace epafi::contact {

/// The load cannot be balanced, or no position was found in which contact and friction
/// balance it.
struct NoBalance : bem::NumericalError {
  NoBalance();
  using bem::NumericalError::NumericalError;
};

/// A rigid motion along which the load is larger than any force of contact and friction.
struct UnresistedMotion {
  Vector amplitudes;  ///< v, one per free rigid motion; empty: the load can be balanced
  double load = 0;    ///< v·q
  double held = 0;    ///< the most that contact and friction do along v, less than `load`
};

/// A motion v that separates the load from the contact forces, v·q > v·c for all of them; none
/// if q is one of them up to rounding.  Contact forces are the sums of a cone and of segments:
///
///   Gₙ,   Gₙ ± s' Gₜ,   ± Gₜ if s(0) = ∞        generate the cone,
///   [-s(0), s(0)] Gₜ,   [0, C/s'] (Gₙ ± s' Gₜ)   in place of Gₙ ± s' Gₜ if s <= s(0) + C,
///
/// s': the largest slope of the slip bound, PointLaw::steepest.  Motions with springs are
/// left out.  By nonnegative least squares in the cone of (c, 0) and (z, 1), z the vertices of
/// the sum of the segments, which are formed as they are needed.     [Lawson & Hanson 1974]
UnresistedMotion unresistedMotion(const Problem& problem);

/// \throws NoBalance if there is an unresistedMotion().
void requireEquilibrium(const Problem& problem);

}  // namespace epafi::contact
