#pragma once

#include "adaptivity/estimate/EndValues.hpp"
#include "adaptivity/estimate/Indicators.hpp"
#include "bem/quadrature/LegendreSeries.hpp"
#include "bem/quadrature/Piecewise.hpp"
#include "contact/results/Summary.hpp"

#include <algorithm>

namespace epafi::adaptivity {

using ContactElement = contact::MultiplierSpace::ContactElement;

/// x⁺
inline double positive(double x) { return std::max(x, 0.0); }

/// A polynomial on [-1, 1] as a Legendre series.
class Polynomial {
 public:
  /// Of a polynomial of at most this degree, from its values at Gauss points.
  Polynomial(const bem::Profile& values, int degree)
      : series_(bem::project(values, degree)), degree_(degree) {}
  double operator()(double t) const { return bem::evaluate(series_, degree_, t); }

 private:
  bem::LegendreSeries<double> series_;
  int degree_;
};

/// What a contact element's terms are made of; functions of t, dimensionless.
struct ContactProfiles {
  Polynomial pressure;  ///< λₙ
  Polynomial shear;     ///< λₜ
  bem::Profile
      tangential;        ///< uₜ less elastic shear and sliding; in a step what is added
  bem::Profile opening;  ///< g - uₙ, what the sides yield by included
  bem::Profile bound;    ///< s, for the pressure's positive part
  int degree;
  double half;           ///< of the element's length
  Vector nodes{};        ///< of what is met, in (-1, 1)
  int highest = degree;  ///< degree of the displacements, that of what is met included
  bool tied = false;     ///< are the sides bonded?
  /// p/h of what is met over that of the side, where that is finer; else 1.
  bem::Profile fineness = [](double) { return 1.0; };
  /// φ' of sides that yield or wear, at a place of this opening; else 0.
  std::function<double(double t, double opening)> yield = [](double, double) {
    return 0.0;
  };
  bem::Profile shearYield = [](double) { return 0.0; };  ///< likewise of shear
};

/// Of λʰ + valueAt(correction); s is that of its pressure.
ContactProfiles contactProfiles(const contact::Solved& solved,
                                const ContactElement& element, const AtEnds& correction);

/// Squares of the last five sources on one contact element, dimensionless, as printed:
///
///   ∫ λₙ⁺ (g-uₙ)⁺,  p/h |(g-uₙ)⁻|²,  h/p |λₙ⁻|²,  h/p |(|λₜ|-s)⁺|²,
///   ∫ (s-|λₜ|)⁺ |uₜ| + |λₜ||uₜ| - λₜuₜ                                   [P sec. 8]
///
/// The rule breaks wherever one of the signs changes.  Bonded sides have
/// p/h (|g-uₙ|² + |uₜ|²) in the second place, and nothing else.
Contributions contactTerms(const ContactProfiles& profiles);

/// The same with smaller terms for the first and the last, in the scaled norms of
/// [P] sec. 8 and for converged states (doc/theory/estimators.md):
///
///   ∫ H(λₙ⁺, (g-uₙ)⁺),   ∫ H(s - λ̃ sign uₜ, |uₜ|),   λ̃ = max(-s, min(s, λₜ)),
///
/// H = lostWork for the stiffness μ p/h, that of the finer side for lengths.  Where sides yield,
/// an error of the length may be one of the pressure: p/h is 1/(h/p + μ φ') there.
Contributions sharpContactTerms(const ContactProfiles& profiles, double shearModulus);

/// What a force along a length that excludes it adds to the squared error, split between
/// the two:
///
///   min  f₁ v₁ + (force - f₁)² / soft + stiff (length - v₁)²,  f₁, v₁ >= 0.
///
/// \pre soft <= stiff.  Forces live on the side that carries the multiplier, lengths are
/// differences of displacements of both sides, the finer one's included.
///
/// What is taken from the force is an error of the multiplier, what is taken from the
/// length one of the displacement; both count squared, in the scaled L² norms of
/// [P] sec. 8 and with Young's constants 1.  No proven bound: it stands for norms of
/// order -1/2 and 1/2 only where force and length overlap on the scale h/p, as they do in
/// converged states, whose coefficients exclude each other.
double lostWork(double force, double length, double soft, double stiff);
/// For one stiffness of both.
inline double lostWork(double force, double length, double stiffness) {
  const double back = stiffness * length;  // what the length opposes as a force
  if (2 * back <= force)
    return back * length;
  if (2 * force <= back)
    return force * force / stiffness;
  const double workingForce = (4 * force - 2 * back) / 3;
  const double workingBack = (4 * back - 2 * force) / 3;
  return (workingForce * workingBack +
          0.25 * (workingForce * workingForce + workingBack * workingBack)) /
         stiffness;
}

}  // namespace epafi::adaptivity
