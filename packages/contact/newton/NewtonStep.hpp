#pragma once

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

class FactorMemory;

/// A step after which a rigid motion is held that is not now, see NewtonSystem::unheld:
/// closed places of Coulomb friction stick for this step, whatever their bound; where this
/// does not help, the body moves until the penalty forces P(λ + c r) balance the load.
/// `rows`, here and below: the point's own, or of other sets; `memory`: see NewtonSystem.
/// \throws NoBalance if no such position exists: the load has no counterpart.
Vector placingStep(const Equation& equation, const Evaluation& at, const LinearRows& rows,
                   const Vector& motion, FactorMemory* memory = nullptr);

/// J⁻¹ (-F) of the rows or, where a rigid motion is not held, placingStep().
Vector newtonStep(const Equation& equation, const Evaluation& at, const LinearRows& rows,
                  FactorMemory* memory = nullptr);

}  // namespace epafi::contact
