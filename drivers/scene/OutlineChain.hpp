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
  std::string boundary;  ///< its name
  int fileLine = 0;      ///< where the file has it, for messages
};

/// What a file says of a body's boundary: pieces in no order.
struct OutlinePieces {
  std::map<NodeTag, bem::Vec2> nodes;  ///< all that pieces name
  std::vector<OutlinePiece> pieces;
  std::string advice;  ///< what may be wrong with the file where an outline ends or forks
};

/// The closed loops that the pieces chain into; the one with the largest area is the outer
/// polygon.  Neighbouring pieces of one name on one straight line become one edge, those on
/// one circle too, up to half of it.  A loop starts at its corner with the smallest node.
/// \throws bem::InputError naming the line of the file for a piece from a node to itself,
///   two equal ones, open chains, forks and loops without area.
bem::Loops chained(const OutlinePieces& pieces);

}  // namespace epafi::drivers
