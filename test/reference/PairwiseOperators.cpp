#include "reference/PairwiseOperators.hpp"

#include "bem/moments/PairBatch.hpp"
#include "bem/operators/Scatter.hpp"

#include <algorithm>

namespace epafi::reference {

bem::Operators pairwiseOperators(const bem::Space& space, const bem::Lame& lame,
                                 const bem::DenseAlgebra& algebra) {
  const bem::Index densities = algebra.myRows(space.densities()).size();
  const bem::Index displacements = algebra.myRows(space.displacements()).size();
  bem::Operators out{bem::Matrix(densities, space.densities()),
                     bem::Matrix(densities, space.displacements()),
                     bem::Matrix(displacements, space.displacements()),
                     {}};
  const bem::Scatter scatter(space, lame, algebra, out);
  const bem::ElementRuns runs(space.mesh());
  bem::PairBatch batch(runs);
  for (int e = 0; e < space.mesh().size(); ++e)
    for (int r = 0; r * bem::lanes <= e; ++r) {
      const bem::ElementRange wanted = {runs[r].first, std::min(runs[r].last, e + 1)};
      batch.choose(e, r, wanted);
      for (int f = wanted.first; f < wanted.last; ++f)
        scatter.add(e, f, batch.at(f));
    }
  return out;
}

}  // namespace epafi::reference
