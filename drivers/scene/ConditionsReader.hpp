#pragma once

#include "bem/geometry/Outline.hpp"
#include "contact/conditions/Conditions.hpp"
#include "drivers/scene/Part.hpp"
#include "drivers/scene/Symmetry.hpp"

namespace epafi::drivers {

/// Reads Boundary Conditions and Rigid Motions of a body.  Edges on the line of symmetry
/// become rollers; motions that are zero by symmetry are removed from Fix.
/// \throws bem::InputError for an unknown boundary (with the nearest name), a Dirichlet
///   condition without a component, an invalid expression, and a force beside a traction.
contact::Conditions readConditions(const Part& body, const bem::Outline& outline,
                                   const Symmetry& symmetry);

/// \throws bem::InputError if no edge has this name, with the nearest name.
void checkNamed(const std::string& boundary, const std::string& path,
                const bem::Outline& outline);

/// Reads interference and surface of a list under Contacts, whose names include the
/// normal.
contact::Conditions::Contact readContactOfBodies(const Part& part);

/// The outward normal at a point of a boundary, in the user's coordinates: that of the
/// nearest edge with this name.
std::function<bem::Vec2(bem::Vec2)> normalOn(const bem::Outline& outline,
                                             const std::string& boundary);

}  // namespace epafi::drivers
