#pragma once

#include "bem/geometry/Outline.hpp"

#include <string>

namespace epafi::drivers {

/// The outline in a Gmsh mesh (.msh, format 4.1, ASCII or binary).
///
/// Read are the line elements that belong to a physical group; the group's name (its
/// number where it has none) is the boundary's name.  Lines of second order are the circular
/// arcs through their three nodes.  They must chain into closed loops; the one with the
/// largest area is the outer polygon.  Neighbouring lines of one name on one straight line
/// become one edge, those on one circle too, up to half of it.  A loop starts at its corner
/// with the smallest node number, which is the geometry's first point.  Other elements are
/// skipped.
/// \throws bem::InputError naming the line of the file, the byte of a binary one, for what is no mesh, or a mesh
///   that is no outline: lines of third or higher order, open chains, forks, a mesh that is
///   not in a plane of constant z.
bem::Loops readGmsh(const std::string& text);

}  // namespace epafi::drivers
