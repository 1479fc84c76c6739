#pragma once

#include "adaptivity/estimate/EndValues.hpp"
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

/// Of λʰ + valueAt(correction); s is that of its pressure.
ContactProfiles contactProfiles(const contact::Solved& solved,
                                const ContactElement& element, const AtEnds& correction);

/// Which shear the slip term sees.
enum class SlipTerm {
  Printed,  ///< λₜ itself:  ∫ (s-|λₜ|)⁺ |uₜ| + |λₜ||uₜ| - λₜuₜ             [P sec. 8]
  Admissible  ///< its part λ̃ within the bound:  ∫ s |uₜ| - λ̃ uₜ
};

/// Squares of the last five sources on one contact element, dimensionless:
///
///   ∫ λₙ⁺ (g-uₙ)⁺,  p/h |(g-uₙ)⁻|²,  h/p |λₙ⁻|²,  h/p |(|λₜ|-s)⁺|²,
///   and one of SlipTerm's                                                [P sec. 8]
///
/// Both slip terms bound the error: of  <λₜ - λₜʰ, uₜʰ - uₜ>  the part of λₜʰ beyond s is
/// paired with uₜʰ - uₜ and so belongs to the fourth term, squared.  As printed it is
/// paired with uₜʰ as well, where it has the wrong sign: an excess of first order,
/// ∫ 2 |λₜ| |uₜ|, which hides all others where pressure dips below zero next to the end
/// of contact.
/// The rule breaks wherever one of the signs changes.
Contributions contactTerms(const ContactProfiles& profiles, SlipTerm slipTerm);

}  // namespace epafi::adaptivity
