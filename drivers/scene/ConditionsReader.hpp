#pragma once

#include "bem/geometry/Outline.hpp"
#include "contact/conditions/Conditions.hpp"
#include "drivers/scene/Expression.hpp"

namespace Teuchos {
class ParameterList;
}

namespace epafi::drivers {

/// The Boundary Conditions and Rigid Motions of a body's validated list at a time t; `place`
/// is the body's.
/// \throws bem::InputError for a boundary that no edge has (the nearest name is given), a
///   Dirichlet condition without a component, an expression that is none.
contact::Conditions readConditions(const Teuchos::ParameterList& body, const Place& place,
                                   const bem::Outline& outline, double t = 1);

/// \throws bem::InputError for a boundary that no edge has, with the nearest name.
void checkNamed(const std::string& boundary, const std::string& path,
                const bem::Outline& outline);

/// Interference and Friction of a validated list under Contacts at a time t.
contact::Conditions::Contact readContactOfBodies(const Teuchos::ParameterList& list,
                                                 const Place& place, double t = 1);

}  // namespace epafi::drivers
