#pragma once

#include "adaptivity/estimate/Indicators.hpp"
#include "adaptivity/estimate/SidePlaces.hpp"
#include "bem/basis/EndValues.hpp"
#include "bem/quadrature/LegendreSeries.hpp"
#include "bem/quadrature/Piecewise.hpp"
#include "contact/results/Summary.hpp"

#include <algorithm>

namespace epafi::adaptivity {

using ContactElement = contact::MultiplierSpace::ContactElement;

/// Vectors at the start and the end of an element.
struct AtEnds {
  bem::Vec2 start;
  bem::Vec2 end;
};

/// (factors.start e(-t) + factors.end e(t)) / half at a point of an element, see
/// bem::endValues.
bem::Vec2 valueAt(const AtEnds& factors, const bem::Element& element, double t);

/// x⁺
inline double positive(double x) { return std::max(x, 0.0); }

/// A polynomial on [-1, 1] as a Legendre series.
class Polynomial {
 public:
  /// A polynomial of at most this degree, from its values at Gauss points.
  Polynomial(const bem::Profile& values, int degree)
      : Polynomial(bem::project(values, degree), degree) {}
  Polynomial(const bem::LegendreSeries<double>& series, int degree)
      : series_(series), degree_(degree) {}
  double operator()(double t) const { return bem::evaluate(series_, degree_, t); }

 private:
  bem::LegendreSeries<double> series_;
  int degree_;
};

/// Data for the terms of a contact element; functions of t, dimensionless.
struct ContactProfiles {
  Polynomial pressure;  ///< λₙ
  Polynomial shear;     ///< λₜ
  bem::Profile
      tangential;        ///< uₜ less elastic shear and sliding; in a step its increment
  bem::Profile opening;  ///< g - uₙ, what the sides yield by included
  bem::Profile bound;    ///< s, for the pressure's positive part
  int degree;
  double half;           ///< of the element's length
  bem::Profile measure;  ///< bem::Mesh::measure
  Vector nodes{};        ///< opposite nodes, in (-1, 1)
  int highest = degree;  ///< largest degree of the displacements of both sides
  bool tied = false;     ///< are the sides bonded?
  /// Of lengths: p/h of the opposite side over that of this side, or the stiffness of a held layer
  /// over μ p/h, the largest; at least 1.
  bem::Profile fineness = [](double) { return 1.0; };
  /// φ' of sides that yield or wear, at a place of this opening; else 0.
  std::function<double(double t, double opening)> yield = [](double, double) {
    return 0.0;
  };
  bem::Profile shearYield = [](double) { return 0.0; };  ///< likewise of shear
  std::function<bem::Vec2(double)> direction{};          ///< d of contact
};

/// Profiles for the multiplier λʰ + valueAt(correction) and the bound s of its pressure.
/// Refers to its arguments.
ContactProfiles contactProfiles(const contact::Solved& solved,
                                const ContactElement& element, const AtEnds& correction,
                                KnownPlaces& places);

/// Squares of the last five sources on one contact element, dimensionless, as printed:
///
///   ∫ λₙ⁺ (g-uₙ)⁺,  p/h |(g-uₙ)⁻|²,  h/p |λₙ⁻|²,  h/p |(|λₜ|-s)⁺|²,
///   ∫ (s-|λₜ|)⁺ |uₜ| + |λₜ||uₜ| - λₜuₜ                                   [P sec. 8]
///
/// The quadrature rule has a break at each change of sign.  Bonded sides have only the second
/// term, p/h (|g-uₙ|² + |uₜ|²).
Contributions contactTerms(const ContactProfiles& profiles);

/// contactTerms with smaller first and last terms, in the scaled norms of [P] sec. 8 and for
/// converged states (doc/theory/estimators.md):
///
///   ∫ H(λₙ⁺, (g-uₙ)⁺),   ∫ H(s - λ̃ sign uₜ, |uₜ|),   λ̃ = max(-s, min(s, λₜ)),
///
/// H = lostWork with the stiffness μ p/h, for lengths that of the finer side.  With compliant
/// surfaces p/h is replaced by 1/(h/p + μ φ').
Contributions sharpContactTerms(const ContactProfiles& profiles, double shearModulus);

/// Has an element no pressure but rounding?
bool isOpen(const Vector& multiplier, const ContactElement& element, double rounding);

/// Of an element that is open: what overlaps there, between the points that keep sides apart, varies on
/// the length of the part that overlaps, if that is shorter than h/p.
void narrow(ContactProfiles& profiles);

/// Squared error due to a force and a length whose product should be zero, with the best split
/// between both errors:
///
///   min  f₁ v₁ + (force - f₁)² / soft + stiff (length - v₁)²,  f₁, v₁ >= 0.
///
/// \pre soft <= stiff.  Forces live on the side that carries the multiplier, lengths are
/// differences of displacements of both sides, the finer one's included.
///
/// The part of the force is an error of the multiplier, the part of the length an error of the
/// displacement; both squared in the scaled L² norms of [P] sec. 8, with constants 1 in Young's
/// inequality.  Not a proven bound: it replaces norms of order -1/2 and 1/2 only if force and
/// length overlap on the scale h/p, as in converged states, whose coefficients are
/// complementary.
double lostWork(double force, double length, double soft, double stiff);
/// lostWork for soft = stiff = stiffness.
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
