#pragma once

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

class FactorMemory;

/// A step after which a rigid motion is held that is not now, see NewtonSystem::unheld: a body
/// that hangs free or slides everywhere is put where contact can hold it, whatever the gap.
///
/// Closed places of Coulomb friction stick for this step, whatever their bound; where this
/// does not help, the body moves along the motion until contact and friction, as if they were
/// springs, and the springs that it has balance the load.  `memory`: see NewtonSystem.
/// \returns the change of x = (λ, α)
/// \throws NoBalance if no such position exists: the load has no counterpart.
Vector placingStep(const Equation& equation, const Evaluation& at, const Vector& motion,
                   FactorMemory* memory = nullptr);

/// Would a step of x, which springs alone hold, carry a body far into what it does not touch now, or
/// past stick to where all slips backwards?  Newton's method would not come back from there.
bool overshoots(const Equation& equation, const Evaluation& at, const Vector& step);

}  // namespace epafi::contact
