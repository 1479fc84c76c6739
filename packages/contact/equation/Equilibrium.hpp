#pragma once

#include "bem/base/Error.hpp"
#include "contact/problem/Problem.hpp"

namespace epafi::contact {

/// What is wrong when nothing balances the load, and what to do.
inline constexpr const char* noBalance =
    "the load moves the body along a rigid motion that nothing holds: neither contact "
    "nor friction can balance its resultant; hold the motion (Rigid Motions -> Fix, or a "
    "Dirichlet condition), or change the load or the friction";

/// Throws if no contact forces at all balance the load: q must lie in the cone of
///
///   λₙ (Gₙ ± s'(0) Gₜ),  λₙ >= 0,     s' the slope of the slip bound
///
/// over all places; Tresca's friction counts as unlimited here.  The proof is a rigid
/// motion v with v·c <= 0 for every column c of the cone and v·q > 0, found by
/// non-negative least squares [Lawson & Hanson 1974]; without a clear one nothing is
/// thrown.
/// \throws bem::NumericalError
void requireEquilibrium(const Problem& problem);

/// No position of the body was found in which contact and friction balance the load.
struct NoBalance : bem::NumericalError {
  using bem::NumericalError::NumericalError;
};

/// The part of q that pressure alone cannot balance, at least nearly: q minus the nearest
/// point of the cone of the normals.
Vector loadOfFriction(const Problem& problem);

}  // namespace epafi::contact
