#pragma once

#include "bem/base/DenseAlgebra.hpp"
#include "bem/space/Space.hpp"

#include <vector>

namespace epafi::bem {

/// By element: has this process a row of it, of a density or of a displacement?  It needs the
/// pairs with these and no others.
inline std::vector<bool> myElements(const Space& space, const DenseAlgebra& algebra) {
  const Rows densities = algebra.myRows(space.densities());
  const Rows displacements = algebra.myRows(space.displacements());
  std::vector<bool> result;
  for (int e = 0; e < space.mesh().size(); ++e) {
    const Element& element = space.mesh()[e];
    bool mine = false;
    for (int c = 0; c < 2; ++c) {
      for (int k = 0; k <= element.degree; ++k)
        mine = mine || displacements.contain(space.displacement(e, k, c));
      for (int i = 0; i < element.densities; ++i)
        mine = mine || densities.contain(space.density(e, i, c));
    }
    result.push_back(mine);
  }
  return result;
}

}  // namespace epafi::bem
