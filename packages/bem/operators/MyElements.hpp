#pragma once

#include "bem/base/DenseAlgebra.hpp"
#include "bem/space/Space.hpp"

namespace epafi::bem {

/// The elements of which this process has a row, of a density or of a displacement: it
/// needs the pairs with them and no others.
class MyElements {
 public:
  MyElements(const Space& space, const DenseAlgebra& algebra)
      : mine_(static_cast<std::size_t>(space.mesh().size())) {
    const Rows densities = algebra.myRows(space.densities());
    const Rows displacements = algebra.myRows(space.displacements());
    for (int e = 0; e < space.mesh().size(); ++e) {
      bool mine = false;
      for (int c = 0; c < 2; ++c)
        for (int k = 0; k <= space.mesh()[e].degree; ++k)
          mine =
              mine || displacements.contain(space.displacement(e, k, c)) ||
              (k < space.mesh()[e].degree && densities.contain(space.density(e, k, c)));
      mine_[static_cast<std::size_t>(e)] = mine;
    }
  }

  bool contain(int e) const { return mine_[static_cast<std::size_t>(e)]; }

 private:
  std::vector<bool> mine_;
};

}  // namespace epafi::bem
