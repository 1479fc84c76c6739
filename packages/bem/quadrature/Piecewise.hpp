#pragma once

#include "bem/quadrature/Gauss.hpp"

#include <functional>

namespace epafi::bem {

/// A function on [-1, 1].
using Profile = std::function<double(double)>;

/// Where a continuous function changes its sign inside (-1, 1), to rounding, found by as
/// many samples as separate the zeros of a polynomial of this degree in practice.
Vector signChanges(const Profile& f, int degree);
/// These samples' places, and the same from the values there.
Vector signSamples(int degree);
Vector signChanges(const Profile& f, const Vector& places, const Vector& values);

/// A rule over [-1, 1] with `order` Gauss points on each piece between the given breaks,
/// which may come in any order.
Rule piecewiseRule(Vector breaks, int order);

}  // namespace epafi::bem
