#pragma once

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

/// ½ |F|² with Fischer-Burmeister's function in place of the projection: it has the same zeros.
double merit(const Equation& equation, const Evaluation& at);
/// Its gradient: continuous as long as the slip bound is differentiable.
Vector meritGradient(const Equation& equation, const Evaluation& at);

}  // namespace epafi::contact
