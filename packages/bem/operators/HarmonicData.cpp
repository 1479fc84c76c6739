#include "bem/operators/HarmonicData.hpp"

#include "bem/mesh/Surfaces.hpp"

#include <algorithm>

namespace epafi::bem {

std::vector<bool> missingData(const Space& space,
                              const std::vector<bool>& isPotentialGiven) {
  std::vector<bool> isMissing(at(space.displacements() + space.densities()), false);
  std::fill_n(isMissing.begin(), space.displacements(), true);
  const Mesh& mesh = space.mesh();
  for (int e = 0; e < mesh.size(); ++e)
    if (isPotentialGiven[at(e)]) {
      for (int k = 0; k <= mesh[e].degree; ++k)
        isMissing[at(potentialOf(space, e, k))] = false;
      for (int i = 0; i < mesh[e].densities; ++i)
        isMissing[at(flowOf(space, e, i))] = true;
    }
  return isMissing;
}

void FreeSurface::addConstant(const Vector& missed, Vector& data) const {
  double sum = 0;
  for (const Index i : flows)
    sum += missed[at(i)];
  for (const Index j : nodes)
    data[at(j)] += sum / size;
}

std::vector<FreeSurface> freeSurfaces(const Space& space,
                                      const std::vector<bool>& isPotentialGiven) {
  std::vector<FreeSurface> result;
  const std::vector<Surface> surfaces = surfacesOf(space.mesh());
  for (std::size_t k = 1; k < surfaces.size(); ++k) {
    const std::vector<int>& elements = surfaces[k].elements;
    if (std::any_of(elements.begin(), elements.end(),
                    [&](int e) { return isPotentialGiven[at(e)]; }))
      continue;
    FreeSurface& surface = result.emplace_back();
    surface.size = surfaces[k].size;
    for (const int e : elements) {
      surface.flows.push_back(flowOf(space, e, 0));
      surface.nodes.push_back(potentialOf(space, e, 0));
    }
    if (!surfaces[k].isClosed)
      surface.nodes.push_back(potentialOf(space, elements.back(), 1));
  }
  return result;
}

}  // namespace epafi::bem
