#pragma once

#include "bem/base/Vec2.hpp"

#include <map>
#include <string>
#include <vector>

namespace epafi::drivers {

using GmshTag = long;

struct GmshNode {
  bem::Vec2 place;
  double z = 0;
};

/// An element of first or second order on a physical curve.
struct GmshLine {
  GmshTag from = 0;
  GmshTag to = 0;
  GmshTag middle = 0;  ///< of a line of second order, else 0
  GmshTag group = 0;
  int fileLine = 0;
};

/// What a .msh file says of boundaries: nodes, physical curves and the lines on them.
struct GmshMesh {
  std::map<GmshTag, std::string> names;            // of the physical curves
  std::map<GmshTag, std::vector<GmshTag>> groups;  // of the curves
  std::map<GmshTag, GmshNode> nodes;
  std::vector<GmshLine> lines;
};

/// Reads ASCII, format 4.1; elements that are no lines of a physical group are skipped.
/// \throws bem::InputError naming the line of the file, for what is no mesh, has another
///   format, lines of third or higher order, or no line in a physical group.
GmshMesh readGmshMesh(const std::string& text);

}  // namespace epafi::drivers
