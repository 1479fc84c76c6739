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

/// Reads an outline from a drawing (.dxf, ASCII, any version).
///
/// Uses LINE, ARC, CIRCLE, LWPOLYLINE and POLYLINE of model space; the name of the layer
/// is the name of the boundary.  Ends closer than 1e-6 of the size of the drawing are one
/// corner.  The pieces form closed loops, see chained().  Texts, dimensions, points and
/// hatches are skipped; the unit of the drawing is ignored.
/// \throws bem::InputError with the line of the file for an invalid drawing, outline or
///   number, and for other curves (splines, ellipses, blocks).
bem::Loops readDxf(const std::string& text);

}  // namespace epafi::drivers
