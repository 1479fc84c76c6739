#pragma once

#include "contact/system/BodyParts.hpp"

namespace epafi::contact {

/// What slip has done to the contact sides of a body up to a step of a path, dimensionless values
/// at the p + 1 Gauss points of each element, see MultiplierSpace::throughPoints:
///
///   w = w⁻ + n k |Δs| λₙ,   Δs the step's slip, n how many times it happens.
///                                                              doc/theory/surfaces.md
struct Wear {
  Vector depth;     ///< w
  Vector distance;  ///< Σ n |Δs| of where sides are closed
  Vector slid;      ///< m, what slid by
  Vector rate;      ///< n k |Δs| of the step: by how much more a pressure wears
};

/// Does anything wear there?
bool wears(const MultiplierSpace& multiplier);

/// |Δs| at the points: that of m without friction, else Σ χ_i |Δrₜ,i| / ∫ χ_i ds, at Gauss points
/// of Lagrange's polynomials there the means.  `slip`: Δrₜ, one per coefficient; empty: not known,
/// that of m.
Vector slips(const BodyParts& body, const Wear& before, const Vector& slip);

/// n k times slips.
Vector wearRate(const BodyParts& body, Vector slips);

/// ∫ rate χ_i χ_j, own numbers of normal coefficients.
std::vector<bem::Entry> wearing(const BodyParts& body, const Vector& rate);

/// ∫ f χ_i of values at the points, one per coefficient.
Vector tested(const BodyParts& body, const Vector& values);

/// Behind a step with these slips and rates.
Wear wearBehind(const BodyParts& body, const Wear& before, const Vector& slips,
                const Vector& rate, const Vector& multiplier);

}  // namespace epafi::contact
