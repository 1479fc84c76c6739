#pragma once

#include "contact/multiplier/MultiplierBasis.hpp"

#include <functional>

namespace epafi::contact {

/// What limits the coefficients of an element's shear where a bound s(t) >= 0, t in
/// [-1, 1], limits the shear: as many numbers >= 0 as the basis has functions.
///
/// The values of s at the basis' places, unless coefficients are control points.  Then
///
///   c = coefficients of the polynomial that meets s at the Gauss-Lobatto points, none <
///   0,
///
/// if it is closer to s than the one with the values at the control points and none of c
/// is beyond the largest and the smallest of s, or if it is four times as close.  So a
/// smooth bound is met to order q + 1, values at control points being second order. Where
/// s jumps by J, c is within the hull of s, too: no continuous function is closer than J
/// / 2, and the values' is within J.
bem::Vector boundCoefficients(const MultiplierBasis& basis, int degree,
                              const std::function<double(double)>& bound);

/// How a pressure's coefficients λ limit those of an element's shear:
///
///   s_i = Σ_j T_ij λ_j,   where T is not diagonal kept within least λ_i and most λ_i.
struct PressureBound {
  bem::Matrix strengths;  ///< T
  bool coupled = false;   ///< T is not diagonal
  double least = 0;       ///< >= 0
  double most = 0;
};

/// For a bound f(t) λ(t), f >= 0 on [-1, 1], λ = Σ λ_j χ_j.
///
/// T is diagonal with boundCoefficients of f, unless coefficients are control points and
/// f is not constant: control points of a product are not the products of control points.
/// Where boundCoefficients takes the polynomial through the Gauss-Lobatto points, T λ are
/// the coefficients of the one that meets f λ there, of order q + 1; least and most are
/// those of f, so that the bound stays between them times the pressure.  Smooth f with an
/// extremum inside, whose own coefficients are outside, get as much again as f and they
/// vary: s_i = (T λ)_i then wherever λ varies little on the element.  No s_i is negative
/// for λ >= 0, and where λ_i is zero, s_i is.
PressureBound pressureBound(const MultiplierBasis& basis, int degree,
                            const std::function<double(double)>& factor);

}  // namespace epafi::contact
