#pragma once

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

class FactorMemory;

/// A step after which a rigid motion is held that is not now, see NewtonSystem::unheld: a body
/// that hangs free or slides everywhere is put where contact can hold it, whatever the gap.
///
/// Closed places of Coulomb friction stick for this step, whatever their bound; where this
/// does not help, the body moves along the motion until contact and friction, as if they were
/// springs, balance the load.  `memory`: see NewtonSystem.
/// \returns the change of x = (λ, α)
/// \throws NoBalance if no such position exists: the load has no counterpart.
Vector placingStep(const Equation& equation, const Evaluation& at, const Vector& motion,
                   FactorMemory* memory = nullptr);

}  // namespace epafi::contact
