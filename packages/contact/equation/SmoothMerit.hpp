#pragma once

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

/// Ψ = ½ |F|² with the Fischer-Burmeister function in place of the projection; same zeros.
double merit(const Equation& equation, const Evaluation& at);
/// ∇Ψ, continuous if the slip bound is continuously differentiable.
Vector meritGradient(const Equation& equation, const Evaluation& at);

}  // namespace epafi::contact
