#pragma once

#include "contact/solve/Equation.hpp"

namespace epafi::contact {

/// J⁻¹ (-F) or, where a rigid motion is not held, a step that makes it so: closed places
/// of Coulomb friction stick for this step, whatever their bound; where this does not
/// help, the body moves until the penalty forces P(λ + c r) balance the load.
/// \throws bem::NumericalError if no such position exists: the load has no counterpart.
Vector newtonStep(const Equation& equation, const Evaluation& at);

}  // namespace epafi::contact
