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
      const Element& element = space.mesh()[e];
      bool mine = false;
      for (int c = 0; c < 2; ++c) {
        for (int k = 0; k <= element.degree; ++k)
          mine = mine || displacements.contain(space.displacement(e, k, c));
        for (int i = 0; i < element.densities; ++i)
          mine = mine || densities.contain(space.density(e, i, c));
      }
      mine_[static_cast<std::size_t>(e)] = mine;
    }
  }

  bool contain(int e) const { return mine_[static_cast<std::size_t>(e)]; }

 private:
  std::vector<bool> mine_;
};

}  // namespace epafi::bem
