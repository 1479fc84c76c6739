#include "bem/operators/Assembly.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/operators/LocalTerms.hpp"
#include "bem/operators/TileWriter.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace epafi::bem {

namespace {

/// The pairs (e, f) with f <= e and f in a group, one thread's.
class ColumnsOfTiles {
 public:
  ColumnsOfTiles(const ElementRuns& runs, TileWriter writer)
      : tile_(runs), runs_(runs), writer_(std::move(writer)) {}

  /// Run by run for all f of the group: the rows that they write stay in cache.
  void assemble(int group) {
    for (int r = group; r < runs_.size(); ++r) {
      writer_.begin(runs_[group], runs_[r]);
      for (int f = runs_[group].first; f < runs_[group].last; ++f) {
        tile_.evaluate(f, r, {std::max(f, runs_[r].first), runs_[r].last});
        writer_.add(tile_);
      }
      writer_.finish();
    }
  }

 private:
  Tile tile_;
  const ElementRuns& runs_;
  TileWriter writer_;
};

/// Groups that a thread takes at once: a few, since a huge page has the columns of
/// several, and two threads that meet in a new one both clear it.
Index groupsAtOnce(Index count) { return std::clamp<Index>(count / 8, 1, 4); }

/// Of all pairs [ns].
double workOf(const Space& space) {
  constexpr double ofPair = 200;
  constexpr double ofEntry = 2;
  const double elements = space.mesh().size();
  const auto unknowns = static_cast<double>(space.densities());
  return 0.5 * (ofPair * elements * elements + ofEntry * unknowns * unknowns);
}

}  // namespace

Operators assembleOperators(const Space& space, const Lame& lame,
                            const std::vector<int>& tractionElements) {
  Operators out{Matrix(space.densities(), space.densities()),
                Matrix(space.densities(), space.displacements()),
                Matrix(space.displacements(), space.displacements()),
                {}};
  const ElementRuns runs(space.mesh());
  GhostNodes ghosts(space, runs);
  // Groups of one colour share no node, so that the columns and the transposed rows that
  // they write are different.
  for (int colour = 0; colour < 2; ++colour) {
    // The first groups have the most pairs: first come, first served, from the front.
    const Index count = (runs.size() + 1 - colour) / 2;
    parallelFor(
        {count, workOf(space) / 2, groupsAtOnce(count)},
        [&] { return ColumnsOfTiles(runs, TileWriter(space, lame, out, ghosts)); },
        [&](ColumnsOfTiles& columns, Index g) {
          columns.assemble(asInt(2 * g + colour));
        });
  }
  ghosts.fold(out);
  std::vector<int> all(static_cast<std::size_t>(space.mesh().size()));
  std::iota(all.begin(), all.end(), 0);
  const auto add = [&](int e, int i, int f, int k, const Block& block) {
    addBlock(out.doubleLayer, space.density(e, i, 0), space.displacement(f, k, 0), block);
  };
  addHalfMass(space.mesh(), all, add);
  addEdgeEnds(space.mesh(), lame, all, all, add);
  out.tractions = projectedTractions(space, lame, tractionElements);
  return out;
}

}  // namespace epafi::bem
