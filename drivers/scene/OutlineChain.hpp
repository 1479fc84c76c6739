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
  double same = 0;     ///< nodes no farther apart are one, that of the smallest number
};

/// What of a file is the body.
struct FilePart {
  std::vector<std::string> boundaries{};  ///< those of its names alone; empty: all
  std::string surface{};                  ///< of a mesh: a physical surface; empty: any
  double scale = 1;                       ///< factor on the file's coordinates
};

/// Joins the pieces to closed loops; that with the largest area is the outer polygon.
/// Neighbours with the same name on a straight line become one edge, those on a circle
/// too, up to half of it.  A loop starts at its corner with the smallest node.  Pieces whose ends
/// are one node are left out.
/// \throws bem::InputError with the line of the file for a piece from a node to itself,
///   two equal pieces, open chains, branches, loops without area, loops outside of the largest, and
///   for boundaries of the part that no piece has.
bem::Loops chained(OutlinePieces pieces, const FilePart& part);

/// Reads an outline from a Gmsh mesh (.msh, format 4.1, ASCII or binary).
///
/// Uses the line elements that belong to a physical group; the name of the group (or its
/// number) is the name of the boundary.  Lines of second order are circular arcs through
/// their three nodes; lines of first order are arcs where all nodes of their curve are on one circle, as
/// Gmsh puts them.  The lines must form closed loops, see chained(): the first corner
/// of a loop is the one with the smallest node number, usually the first point of the
/// geometry.  Of a physical surface lines count that lie on its border.  Other elements are skipped.
/// \throws bem::InputError with the line of the file (in a binary one the byte) if the
///   file is not a mesh or the mesh is not an outline: lines of third or higher order,
///   open chains, branches, nodes with different z.
bem::Loops readGmsh(const std::string& text, const FilePart& part = {});

/// Reads an outline from a drawing (.dxf, ASCII, any version).
///
/// Uses LINE, ARC, CIRCLE, LWPOLYLINE and POLYLINE of model space; the name of the layer
/// is the name of the boundary.  Ends closer than 1e-6 of the size of the drawing are one
/// corner.  The pieces form closed loops, see chained().  Texts, dimensions, points and
/// hatches are skipped; the unit of the drawing is ignored.
/// \throws bem::InputError with the line of the file for an invalid drawing, outline or
///   number, and for other curves (splines, ellipses, blocks).
bem::Loops readDxf(const std::string& text, const FilePart& part = {});

}  // namespace epafi::drivers
