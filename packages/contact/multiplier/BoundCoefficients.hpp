#pragma once

#include "contact/multiplier/MultiplierBasis.hpp"

#include <functional>
#include <vector>

namespace epafi::contact {

/// Bounds of the q + 1 shear coefficients of an element, from the bound s(t) >= 0 of the
/// shear itself, t in [-1, 1]; all >= 0, in the unit of s.
///
/// The values of s at MultiplierBasis::places, unless coefficients are control points.
/// Then
///
///   c = max(0, coefficients of the polynomial that interpolates s at the Gauss-Lobatto points)
///
/// if its largest error is below that of the values at the control points and c is within
/// the range of s, or if its error is at most a quarter.  So the error is of order q + 1
/// for a smooth s (of order 2 with the values).  If s has a jump J, c is within the range
/// of s, since the error of a continuous function is at least J/2 and that of the values
/// at most J.
bem::Vector boundCoefficients(const MultiplierBasis& basis, int degree,
                              const std::function<double(double)>& bound);

}  // namespace epafi::contact
