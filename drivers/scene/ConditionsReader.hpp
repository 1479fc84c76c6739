#pragma once

#include "bem/geometry/Outline.hpp"
#include "contact/conditions/Conditions.hpp"
#include "drivers/scene/Expression.hpp"

namespace Teuchos {
class ParameterList;
}

namespace epafi::drivers {

/// The Boundary Conditions and Rigid Motions of a body's validated list; `place` is the
/// body's.
/// \throws bem::InputError for a boundary that no edge has (the nearest name is given), a
///   Dirichlet condition without a component, an expression that is none.
contact::Conditions readConditions(const Teuchos::ParameterList& body, const Place& place,
                                   const bem::Outline& outline);

}  // namespace epafi::drivers
