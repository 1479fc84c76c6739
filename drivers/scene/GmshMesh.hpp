#pragma once

#include "drivers/scene/OutlineChain.hpp"

#include <map>
#include <string>
#include <vector>

namespace epafi::drivers {

struct GmshNode {
  bem::Vec2 place;
  double z = 0;
};

/// An element of first or second order on a physical curve.
struct GmshLine {
  NodeTag from = 0;
  NodeTag to = 0;
  NodeTag middle = 0;  ///< of a line of second order, else 0
  NodeTag group = 0;
  int fileLine = 0;
};

/// What a .msh file says of boundaries: nodes, physical curves and the lines on them.
struct GmshMesh {
  std::map<NodeTag, std::string> names;            ///< of the physical curves
  std::map<NodeTag, std::vector<NodeTag>> groups;  ///< of the curves
  std::map<NodeTag, GmshNode> nodes;
  std::vector<GmshLine> lines;
};

/// Reads a mesh file of Gmsh, format 4.1, ASCII or binary.
///
/// Elements that are no lines of a physical group are skipped, and what follows the first
/// elements that fill the plane.
/// \throws bem::InputError naming the line of the file, the byte of a binary one
GmshMesh readGmshMesh(const std::string& text);

}  // namespace epafi::drivers
