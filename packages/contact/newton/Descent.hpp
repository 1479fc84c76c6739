#pragma once

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

/// Newton's direction for F = 0, or minus the scaled gradient of ½|F|² where Newton's is
/// none of descent.
Vector meritDescentStep(const Equation& equation, const Evaluation& at);

}  // namespace epafi::contact
