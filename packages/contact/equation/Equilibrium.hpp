#pragma once

#include "bem/base/Error.hpp"
#include "contact/problem/Problem.hpp"

namespace epafi::contact {

/// Nothing balances the load, or no position of the body was found in which contact and
/// friction do.
struct NoBalance : bem::NumericalError {
  NoBalance();
  using bem::NumericalError::NumericalError;
};

/// Throws if no contact forces at all balance the load: q must lie in the cone of
///
///   λₙ (Gₙ ± s'(0) Gₜ),  λₙ >= 0,     s' the slope of the slip bound
///
/// over all places; Tresca's friction counts as unlimited here.  The proof is a rigid
/// motion v with v·c <= 0 for every column c of the cone and v·q > 0, found by
/// non-negative least squares [Lawson & Hanson 1974]; without a clear one nothing is
/// thrown.
/// \throws NoBalance
void requireEquilibrium(const Problem& problem);

/// The part of q that pressure alone cannot balance, at least nearly: q minus the nearest
/// point of the cone of the normals.
Vector loadOfFriction(const Problem& problem);

}  // namespace epafi::contact
