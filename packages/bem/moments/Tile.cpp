#include "bem/moments/Tile.hpp"

#include "bem/moments/FarPairs.hpp"

#include <algorithm>

namespace epafi::bem {

Tile::Tile(const ElementRuns& runs)
    : runs_(runs), moments_(std::make_unique<TileMoments>()) {}

void Tile::evaluate(int trial, int r, const ElementRange& wanted, InstructionSet set) {
  trial_ = trial;
  run_ = r;
  wanted_ = {std::max(wanted.first, run().first), std::min(wanted.last, run().last)};
  const FarLanes chosen = runs_.choose(trial, r, wanted_);
  std::copy_n(chosen.far, lanes, far_);
  farMoments(mesh()[trial], chosen, *moments_, set);
  for (int e = wanted_.first; e < wanted_.last; ++e)
    if (!far_[e - run().first])
      nearMoments(mesh(), trial, e, *moments_, e - run().first, set);
}

}  // namespace epafi::bem
