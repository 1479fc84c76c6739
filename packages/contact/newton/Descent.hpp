#pragma once

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

class FactorMemory;

/// Newton's direction for F = 0, or minus the scaled gradient of ½|F|² where Newton's is
/// none of descent.  `memory`: see NewtonSystem.
Vector meritDescentStep(const Equation& equation, const Evaluation& at,
                        FactorMemory* memory = nullptr);

}  // namespace epafi::contact
