#pragma once

#include "bem/mesh/Mesh.hpp"

#include <array>
#include <vector>

namespace epafi::drivers {

/// The inside of a body as triangles, small at small elements.
struct Triangulation {
  std::vector<bem::Vec2> points;            ///< in the user's coordinates
  std::vector<bool> onBoundary;             ///< of each point
  std::vector<std::array<int, 3>> corners;  ///< of each triangle, counter-clockwise
};

/// Delaunay triangles without angles below 20 degrees, as far as the outline lets them, no
/// larger than a fortieth of the outline.  They end at the elements' nodes and at as many
/// points between them as the size wants.
///
/// By ../libexec/epafi/triangulate seen from this program, which uses CGAL.
/// \throws bem::InputError if that is not there or fails.
Triangulation triangulate(const bem::Mesh& mesh);

}  // namespace epafi::drivers
