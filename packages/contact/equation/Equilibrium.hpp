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

/// Sizes v of the rigid motions along which the load drives and no contact forces at all
/// resist; empty if there are none, or no clear ones.  Contact forces are the cone of
///
///   λₙ (Gₙ ± s'(0) Gₜ),  λₙ >= 0,     s' the slope of the slip bound
///
/// over all places; Tresca's friction counts as unlimited here, and a spring resists what it
/// holds.  v has v·c <= 0 for every
/// column c of the cone and v·q > 0 and proves that q lies outside; it is found by
/// non-negative least squares [Lawson & Hanson 1974].
Vector unresistedMotion(const Problem& problem);

/// \throws NoBalance if there is one.
void requireEquilibrium(const Problem& problem);

}  // namespace epafi::contact
