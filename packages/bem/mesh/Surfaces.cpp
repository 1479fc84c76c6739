#include "bem/mesh/Surfaces.hpp"

#include "bem/base/Matrix.hpp"
#include "bem/quadrature/Gauss.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

/// From e on, to its end at the axis or back to e.
Surface surfaceFrom(const Mesh& mesh, int e) {
  Surface surface;
  surface.isClosed = !mesh.isAxis(mesh[e].previous);
  const Rule& rule = gaussForGiven(1);
  do {
    surface.elements.push_back(e);
    for (std::size_t q = 0; q < rule.points.size(); ++q)
      surface.size += rule.weights[q] * mesh.measure(e, rule.points[q]);
    e = mesh[e].next;
  } while (!mesh.isAxis(e) && e != surface.elements.front());
  return surface;
}

}  // namespace

std::vector<Surface> surfacesOf(const Mesh& mesh) {
  std::vector<Surface> surfaces;
  std::vector<bool> hasAxis(at(mesh.outline().loops()), false);
  const auto loopOf = [&](int e) {
    return at(mesh.outline().edge(mesh[e].piece.edge).loop);
  };
  for (int e = 0; e < mesh.size(); ++e)
    hasAxis[loopOf(e)] = hasAxis[loopOf(e)] || mesh.isAxis(e);
  std::vector<bool> isTaken(hasAxis.size(), false);
  for (int e = 0; e < mesh.size(); ++e) {
    const std::size_t loop = loopOf(e);
    if (mesh.isAxis(e) ||
        (hasAxis[loop] ? !mesh.isAxis(mesh[e].previous) : isTaken[loop]))
      continue;
    isTaken[loop] = true;
    surfaces.push_back(surfaceFrom(mesh, e));
  }
  // of those that meet the axis, all in the first loop, the outer one reaches farthest
  const auto top = [&](const Surface& surface) {
    return surface.isClosed ? -1.0
                            : std::max(mesh.scaledPoint(surface.elements.front(), -1).y,
                                       mesh.scaledPoint(surface.elements.back(), 1).y);
  };
  const auto outer = std::max_element(
      surfaces.begin(), surfaces.end(),
      [&](const Surface& a, const Surface& b) { return top(a) < top(b); });
  std::rotate(surfaces.begin(), outer, outer + 1);
  return surfaces;
}

}  // namespace epafi::bem
