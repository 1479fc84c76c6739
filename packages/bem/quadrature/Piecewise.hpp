#pragma once

#include "bem/quadrature/Gauss.hpp"

#include <functional>

namespace epafi::bem {

/// A function on [-1, 1].
using Profile = std::function<double(double)>;

/// Where a continuous function changes its sign inside (-1, 1), found by sampling
/// `intervals` equal pieces and bisection to rounding.
Vector signChanges(const Profile& f, int intervals);

/// A rule over [-1, 1] with `order` Gauss points on each piece between the given breaks,
/// which may come in any order.
Rule piecewiseRule(Vector breaks, int order);

}  // namespace epafi::bem
