#pragma once

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

/// Moves the body along one rigid motion, as if contact and friction were springs.
///
/// Along α + t v the spring forces P(λ + c r) do the work v·(q - Gᵀ P(λ + c r)), which
/// falls with t; the step goes to its zero.  A body that hangs free or slides everywhere
/// is so put where contact can hold it, whatever the size of the gap.
///
/// Returns the change of x = (λ, α): λ goes to its projection.
/// \throws bem::NumericalError if the work never vanishes: nothing can balance the load.
Vector rigidPlacement(const Equation& equation, const Evaluation& at,
                      const Vector& motion);

}  // namespace epafi::contact
