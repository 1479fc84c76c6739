#pragma once

#include "contact/multiplier/MultiplierBasis.hpp"

#include <functional>
#include <vector>

namespace epafi::contact {

/// What limits the coefficients of an element's shear where a bound s(t) >= 0, t in
/// [-1, 1], limits the shear: as many numbers >= 0 as the basis has functions.
///
/// The values of s at the basis' places, unless coefficients are control points.  Then
///
///   c = coefficients of the polynomial that meets s at the Gauss-Lobatto points,
///       none < 0,
///
/// if it is closer to s than the one with the values at the control points and none of c
/// is beyond the largest and the smallest of s, or if it is four times as close.  So a
/// smooth bound is met to order q + 1, values at control points being second order.  Where
/// s jumps by J, c is within the hull of s, too: no continuous function is closer than
/// J/2, and the values' is within J.
bem::Vector boundCoefficients(const MultiplierBasis& basis, int degree,
                              const std::function<double(double)>& bound);

}  // namespace epafi::contact
