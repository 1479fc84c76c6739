#pragma once

#include "bem/mesh/Mesh.hpp"

#include <array>
#include <vector>

namespace epafi::drivers {

/// The inside of a body as triangles, which are small at small elements.
struct Triangulation {
  std::vector<bem::Vec2> points;            ///< in the user's coordinates
  std::vector<bool> onBoundary;             ///< of each point
  std::vector<std::array<int, 3>> corners;  ///< of each triangle, counter-clockwise
};

/// Delaunay triangles with angles of at least 20 degrees where the outline permits, and
/// sizes up to a fortieth of its diameter.  Their boundary consists of the nodes of the
/// elements and of points between them as the size requires.
///
/// Runs ../libexec/epafi/triangulate (relative to this program), which uses CGAL.
/// \throws bem::InputError if that program is missing or fails.
Triangulation triangulate(const bem::Mesh& mesh);

}  // namespace epafi::drivers
