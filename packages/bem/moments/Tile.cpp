#include "bem/moments/Tile.hpp"

#include "bem/moments/FarPairs.hpp"
#include "bem/moments/NearPairs.hpp"

#include <algorithm>

namespace epafi::bem {

void Tile::evaluate(const ElementRuns& runs, int trial, int r,
                    const ElementRange& wanted) {
  trial_ = trial;
  run_ = &runs[r];
  wanted_ = {std::max(wanted.first, run_->first), std::min(wanted.last, run_->last)};
  const Mesh& mesh = runs.mesh();
  const ElementLanes chosen = runs.choose(trial, r, wanted_);
  std::copy_n(chosen.far, lanes, far_);
  farMoments(mesh[trial], chosen, *this);
  for (int e = wanted_.first; e < wanted_.last; ++e)
    if (!far_[e - run_->first])
      nearMoments(mesh, trial, e, *this, e - run_->first);
}

}  // namespace epafi::bem
