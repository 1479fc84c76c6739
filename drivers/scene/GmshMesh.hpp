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

/// A line element of first or second order on a physical curve.
struct GmshLine {
  NodeTag from = 0;
  NodeTag to = 0;
  NodeTag middle = 0;  ///< 0 for a line of first order
  NodeTag group = 0;
  int fileLine = 0;
};

/// The boundaries in a .msh file: nodes, physical curves and the line elements on them.
struct GmshMesh {
  std::map<NodeTag, std::string> names;            ///< of the physical curves
  std::map<NodeTag, std::vector<NodeTag>> groups;  ///< of the curves
  std::map<NodeTag, GmshNode> nodes;
  std::vector<GmshLine> lines;
};

/// Reads a mesh file of Gmsh, format 4.1, ASCII or binary.
///
/// Elements other than lines of a physical group are skipped.
/// \throws bem::InputError with the line of the file, in a binary one with the byte
GmshMesh readGmshMesh(const std::string& text);

}  // namespace epafi::drivers
