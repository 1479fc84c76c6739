#pragma once

#include "bem/geometry/Outline.hpp"

#include <map>
#include <string>
#include <vector>

namespace epafi::drivers {

using NodeTag = long;

/// A segment or a circular arc between two nodes, in either direction.
struct OutlinePiece {
  NodeTag from = 0;
  NodeTag to = 0;
  double bulge = 0;      ///< tan(angle/4) from `from` to `to`, see bem::Loop
  std::string boundary;  ///< name of the boundary
  int fileLine = 0;      ///< line in the file, for messages
};

/// The boundary of a body as in a file: pieces in any order.
struct OutlinePieces {
  std::map<NodeTag, bem::Vec2> nodes;  ///< all nodes that pieces refer to
  std::vector<OutlinePiece> pieces;
  std::string advice;  ///< hint for an error message where the outline ends
};

/// Joins the pieces to closed loops; that with the largest area is the outer polygon.
/// Neighbours with the same name on a straight line become one edge, those on a circle
/// too, up to half of it.  A loop starts at its corner with the smallest node.
/// \throws bem::InputError with the line of the file for a piece from a node to itself,
///   two equal pieces, open chains, branches, loops without area and loops outside of the
///   largest.
bem::Loops chained(const OutlinePieces& pieces);

}  // namespace epafi::drivers
