#pragma once

#include "adaptivity/estimate/Indicators.hpp"
#include "bem/quadrature/Piecewise.hpp"
#include "contact/problem/Summary.hpp"

namespace epafi::adaptivity {

using ContactElement = contact::MultiplierSpace::ContactElement;

/// A polynomial on [-1, 1] as a Legendre series.
class Polynomial {
 public:
  /// Of a polynomial of at most this degree, from its values at Gauss points.
  Polynomial(const bem::Profile& values, int degree);
  double operator()(double t) const;

 private:
  Vector coefficients_;
};

/// What a contact element's terms are made of; functions of t, dimensionless.
struct ContactProfiles {
  Polynomial pressure;    ///< λₙ
  Polynomial shear;       ///< λₜ
  Polynomial tangential;  ///< uₜ
  bem::Profile opening;   ///< g - uₙ
  bem::Profile bound;     ///< s, for the pressure's positive part
  int degree;
  double half;  ///< of the element's length
};

ContactProfiles contactProfiles(const contact::Solved& solved,
                                const ContactElement& element);

/// Squares of the last five sources on one contact element, dimensionless:
///
///   ∫ λₙ⁺ (g-uₙ)⁺,  p/h |(g-uₙ)⁻|²,  h/p |λₙ⁻|²,  h/p |(|λₜ|-s)⁺|²,
///   ∫ (s-|λₜ|)⁺ |uₜ| + |λₜ||uₜ| - λₜuₜ                                    [P sec. 8]
///
/// The rule breaks wherever one of the signs changes.
Contributions contactTerms(const ContactProfiles& profiles);

}  // namespace epafi::adaptivity
