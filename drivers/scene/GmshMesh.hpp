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
  NodeTag curve = 0;
  int fileLine = 0;
  double bulge = 0;  ///< of a line of first order
};

/// A surface of the geometry.
struct GmshFace {
  std::vector<NodeTag> groups;
  std::vector<NodeTag> curves;  ///< around it
};

/// The boundaries in a .msh file: nodes, physical curves and the line elements on them.
struct GmshMesh {
  std::map<NodeTag, std::string> names;     ///< of the physical curves
  std::map<NodeTag, std::string> surfaces;  ///< likewise
  std::vector<GmshFace> faces;
  std::map<NodeTag, std::vector<NodeTag>> groups;  ///< of the curves
  std::map<NodeTag, GmshNode> nodes;
  std::vector<GmshLine> lines;
};

/// Reads it; elements other than lines of a physical group are skipped.
/// \throws bem::InputError naming the line of the text
GmshMesh readGmshMesh(const std::string& text);

}  // namespace epafi::drivers
