#pragma once

#include "bem/quadrature/Gauss.hpp"

#include <functional>

namespace epafi::bem {

/// A function on [-1, 1].
using Profile = std::function<double(double)>;

/// Zeros in (-1, 1) where a continuous function changes its sign, exact up to rounding.
/// \param degree f is sampled finely enough for polynomials of this degree, in practice
Vector signChanges(const Profile& f, int degree);
/// Places of these samples; and sign changes from the values at such places.
/// \param error  of the zeros, at most.  A rule that has its break so far from a kink errs by its square.
Vector signSamples(int degree);
Vector signChanges(const Profile& f, const Vector& places, const Vector& values,
                   double error = 1e-15);

/// Rule over [-1, 1] with `order` Gauss points on each interval between breaks; these need not
/// be sorted.
Rule piecewiseRule(Vector breaks, int order);

}  // namespace epafi::bem
