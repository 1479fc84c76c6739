#pragma once

#include "bem/base/Matrix.hpp"

#include <functional>

namespace epafi::contact {

/// Corrections up to this size, relative to u, are rounding errors: of u, or of the residual
/// (in long double) times the compliance of the body.
constexpr double roundingOfCorrections = 1e-12;

/// Iterative refinement u <- u + c(u), c(u) the solution with the factor for the residual at u.
///
/// Ends if a correction is at most roundingOfCorrections, after four steps, or before a
/// correction larger than half the previous one, since the factor is then too inaccurate to
/// converge.
bem::Vector refined(bem::Vector u,
                    const std::function<bem::Vector(const bem::Vector&)>& correction);

/// max |x_i|
double largestEntry(const bem::Vector& x);

}  // namespace epafi::contact
