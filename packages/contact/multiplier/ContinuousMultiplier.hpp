#pragma once

#include "contact/multiplier/MultiplierSpace.hpp"

namespace epafi::contact {

/// By contact element of a body: does its contact go on smoothly at both ends, behind a line of
/// symmetry or a roller as its mirror image?
std::vector<char> insideSides(const MultiplierSpace& space, std::size_t body);

/// Coefficients of λ + Σ c_i w_i on the sides of a body, which does the same work as λ on all continuous displacements
/// v of the space but has no jumps at nodes.
///
/// The discrete equations contain λ only in ⟨λ, v⟩, v continuous, so that at every node between
/// two contact elements one jump is arbitrary,
///
///   w_i = e(t)/half before it, -e(-t)/half behind it,   ⟨w_i, v⟩ = v(x_i) - v(x_i) = 0,
///
/// e as in bem::endValues.  [doc/theory/multipliers.md, What is shown]  Next to elements with a
/// transition these jumps are most of the error of λ.
///
/// Jumps remain at vertices of the outline, between two contacts, beside the first and the last
/// element of a side, next to an element with λ = 0
/// (it keeps λ = 0), and for shear where the direction of slip changes, with |λₜ| = `bounds` on
/// both sides.  Bases that share nodes have no jumps.
/// \param bounds slip bounds in place of the tangential coefficients
Vector withoutJumps(const MultiplierSpace& space, std::size_t body,
                    const Vector& multiplier, const Vector& bounds);

}  // namespace epafi::contact
