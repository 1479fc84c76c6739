#pragma once

#include "bem/base/Matrix.hpp"

#include <optional>

namespace epafi::adaptivity {

/// Values of a function at some places.
struct Samples {
  bem::Vector places;
  bem::Vector values;
};

/// Where  v(x) = |x - a|^(3/2) f(x),  f analytic and positive, begins to grow: the zero a
/// of v^(2/3), by a parabola, least squares over the samples with v > 0.
///
/// Exact where f^(2/3) is linear.  Of two zeros it is the one nearer to `guess`.  Nothing
/// with fewer than four such samples, or where the parabola has no zero.
std::optional<double> beginOfGrowth(const Samples& samples, double guess);

}  // namespace epafi::adaptivity
