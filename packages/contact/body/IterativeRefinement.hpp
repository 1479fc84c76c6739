#pragma once

#include "bem/base/Matrix.hpp"

#include <functional>

namespace epafi::contact {

/// A correction that large, relative to u, is rounding: of u itself, or of the residual's
/// long doubles times the body's compliance.
constexpr double roundingOfCorrections = 1e-12;

/// Iterative refinement, u + c(u) and so on: c(u) is what a factor makes of the residual
/// at u.
///
/// Ends with a correction that is no more than rounding, after four steps at the latest,
/// and before one that is not below half the one before: the factor then knows too little
/// of the matrix, and more steps would lead away.
bem::Vector refined(bem::Vector u,
                    const std::function<bem::Vector(const bem::Vector&)>& correction);

/// max |x_i|
double largestEntry(const bem::Vector& x);

}  // namespace epafi::contact
