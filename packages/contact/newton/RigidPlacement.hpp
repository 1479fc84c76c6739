#pragma once

#include "contact/equation/Equation.hpp"

namespace epafi::contact {

/// A step after which contact constrains a rigid motion that is free now
/// (NewtonSystem::unheld): the body has no contact, or slips everywhere.
///
/// First, closed coefficients with Coulomb friction are taken to stick in this step.  If
/// the motion stays free, the body moves along it until the forces P(λ + y) and its
/// springs balance the load.
/// \param motion amplitudes like α
/// \returns the change of x = (λ, α)
/// \throws NoBalance if there is no such position
Vector placingStep(const Equation& equation, const Evaluation& at, const Vector& motion);

/// Does a step of x, in a motion that only springs constrain, close an open contact or
/// reverse slip with |λ + y| more than 10 Problem::stress above the bound?  Newton's
/// method would fail there.
bool overshoots(const Equation& equation, const Evaluation& at, const Vector& step);

}  // namespace epafi::contact
