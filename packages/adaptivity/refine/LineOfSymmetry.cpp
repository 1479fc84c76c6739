#include "adaptivity/refine/LineOfSymmetry.hpp"

#include "adaptivity/refine/Refine.hpp"

#include <algorithm>

namespace epafi::adaptivity {

bem::Mesh gradedLines(bem::Mesh mesh, const contact::Conditions& conditions) {
  constexpr double longest = 2 * (1 + 1e-6);  // twice as long is common, and no more
  const auto marks = [&] {
    Marks halved(mesh.size());
    for (int e = 0; e < mesh.size(); ++e) {
      const bem::Element& element = mesh[e];
      if (!conditions.isBoundary(mesh.boundary(e)) && !mesh.isAxis(e) &&
          element.half >
              longest * std::min(mesh[element.previous].half, mesh[element.next].half))
        halved[e] = Mark::Bisect;
    }
    return halved;
  };
  for (Marks halved = marks(); anyMarked(halved); halved = marks())
    mesh = refine(mesh, halved);
  return mesh;
}

}  // namespace epafi::adaptivity
