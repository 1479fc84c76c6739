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

/// What a law of the pressure needs of one of its fields f >= 0 on an element.
struct PressureBound {
  bem::Vector alone;        ///< for each coefficient alone: boundCoefficients
  bool isConstant = false;  ///< but for rounding
  bool isSmooth = false;    ///< do boundCoefficients take the polynomial through `nodes`?
  bem::Vector nodes{};      ///< the Gauss-Lobatto points
  bem::Vector atNodes{};    ///< f there
  double least = 0;         ///< >= 0
  double most = 0;
};

/// `field`: f at t in [-1, 1].  Where coefficients are values, `alone` is all there is.
///
/// Control points of a product are not the products of control points: with those of
/// f λ_n through the Gauss-Lobatto points the bound is of order q + 1, see Tangential.
/// least and most are those of f, so that the bound stays between what they give.  Smooth f
/// with an extremum inside, whose own coefficients are outside, get as much again as f and
/// they vary: the limits then bite only where λ_n varies much on the element.
PressureBound pressureBound(const MultiplierBasis& basis, int degree,
                            const std::function<double(double)>& field);

/// Does a law with these fields follow all pressures of the element?  Where one is smooth
/// and varies, and none jumps.
bool isCoupled(const std::vector<PressureBound>& fields);

}  // namespace epafi::contact
