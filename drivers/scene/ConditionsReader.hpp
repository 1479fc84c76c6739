#pragma once

#include "bem/geometry/Outline.hpp"
#include "contact/conditions/Conditions.hpp"
#include "drivers/scene/Part.hpp"
#include "drivers/scene/Symmetry.hpp"

namespace epafi::drivers {

/// The Boundary Conditions and Rigid Motions of a body's list, its names without the normal, which
/// each boundary has its own of.  Edges on the line of symmetry are rollers, and what is zero there
/// by itself needs no Fix.
/// \throws bem::InputError for a boundary that no edge has (the nearest name is given), a
///   Dirichlet condition without a component, an expression that is none, a force beside a
///   traction.
contact::Conditions readConditions(const Part& body, const bem::Outline& outline,
                                   const Symmetry& symmetry);

/// \throws bem::InputError for a boundary that no edge has, with the nearest name.
void checkNamed(const std::string& boundary, const std::string& path,
                const bem::Outline& outline);

/// Interference and surfaces of a list under Contacts, its names with the normal.
contact::Conditions::Contact readContactOfBodies(const Part& part);

/// The outward normal of a boundary at points of it, in the user's coordinates: that of the
/// nearest of its edges.
std::function<bem::Vec2(bem::Vec2)> normalOn(const bem::Outline& outline,
                                             const std::string& boundary);

}  // namespace epafi::drivers
