#pragma once

#include "contact/multiplier/MultiplierSpace.hpp"

namespace epafi::contact {

/// λ + Σ c_i w_i, the function with the work of λ on every displacement v of its body that does
/// not jump at nodes, as coefficients.
///
/// The discrete equations know λ by ⟨λ, v⟩ alone, v continuous polynomials of its degree, so
/// that every node between two contact elements has a jump that no equation sees,
///
///   w_i = e(t)/half before it, -e(-t)/half behind it,   ⟨w_i, v⟩ = v(x_i) - v(x_i) = 0,
///
/// e as in bem::endValues.  [doc/theory/multipliers.md, What is shown]  Beside ends of contact
/// and of stick that lie inside an element they are most of what λ errs by.
///
/// Left as they are: jumps at the outline's vertices and between two contacts; beside an element
/// without stress, so that there is none; and of shear between two directions of slip, where
/// λₜ reaches `bounds` from both sides, given as coefficients in place of the tangential ones.
/// A multiplier whose neighbours share coefficients has no jumps.
Vector withoutJumps(const bem::Mesh& mesh, const MultiplierSpace& space,
                    const Vector& multiplier, const Vector& bounds);

}  // namespace epafi::contact
