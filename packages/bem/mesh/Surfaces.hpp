#pragma once

#include "bem/mesh/Mesh.hpp"

#include <vector>

namespace epafi::bem {

/// A connected part of the surface of a body: the outer one, or that of a hole.
struct Surface {
  std::vector<int>
      elements;  ///< in the direction of the outline, none on an axis of revolution
  bool isClosed = true;  ///< in the plane of the outline; else from the axis to the axis
  double size = 0;       ///< length, or area of the whole revolution
};

/// Half the length of what is integrated over: nothing on an axis of revolution.
inline double integratedHalf(const Mesh& mesh, int e) {
  return mesh.isAxis(e) ? 0 : mesh[e].half;
}

/// All of them, the outer one first.  A loop of the outline is one; those of a solid of revolution end
/// at the axis, a hollow sphere has two.
std::vector<Surface> surfacesOf(const Mesh& mesh);

}  // namespace epafi::bem
