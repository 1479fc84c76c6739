#pragma once

#include "bem/geometry/Outline.hpp"

#include <string>

namespace epafi::drivers {

/// Reads an outline from a Gmsh mesh (.msh, format 4.1, ASCII or binary).
///
/// Uses the line elements that belong to a physical group; the name of the group (or its
/// number) is the name of the boundary.  Lines of second order are circular arcs through
/// their three nodes.  The lines must form closed loops, see chained(): the first corner
/// of a loop is the one with the smallest node number, usually the first point of the
/// geometry.  Other elements are skipped.
/// \throws bem::InputError with the line of the file (in a binary one the byte) if the
///   file is not a mesh or the mesh is not an outline: lines of third or higher order,
///   open chains, branches, nodes with different z.
bem::Loops readGmsh(const std::string& text);

}  // namespace epafi::drivers
