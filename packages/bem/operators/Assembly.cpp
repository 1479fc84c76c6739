#include "bem/operators/Assembly.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/operators/LocalTerms.hpp"
#include "bem/operators/MyElements.hpp"
#include "bem/operators/TileWriter.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace epafi::bem {

namespace {

/// The pairs (e, f) with f <= e and f in a group, one thread's.
class ColumnsOfTiles {
 public:
  ColumnsOfTiles(const ElementRuns& runs, const std::vector<bool>& mine,
                 TileWriter writer)
      : tile_(runs), runs_(runs), mine_(mine), writer_(std::move(writer)) {}

  /// Run by run for all f of the group: the rows that they write stay in cache.
  void assemble(int group) {
    for (int r = group; r < runs_.size(); ++r) {
      writer_.begin(runs_[group], runs_[r]);
      for (int f = runs_[group].first; f < runs_[group].last; ++f) {
        const ElementRange wanted = {std::max(f, runs_[r].first), runs_[r].last};
        // the whole tile or nothing: results shall not depend on the number of processes
        if (!isMine(f, wanted))
          continue;
        tile_.evaluate(f, r, wanted);
        writer_.add(tile_);
      }
      writer_.finish();
    }
  }

 private:
  bool isMine(int f, const ElementRange& others) const {
    bool mine = mine_[f];
    for (int e = others.first; e < others.last; ++e)
      mine = mine || mine_[e];
    return mine;
  }

  Tile tile_;
  const ElementRuns& runs_;
  const std::vector<bool>& mine_;
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
                            const DenseAlgebra& algebra,
                            const std::vector<int>& tractionElements) {
  const Rows densities = algebra.myRows(space.densities());
  const Rows displacements = algebra.myRows(space.displacements());
  Operators out{Matrix(densities.size(), space.densities()),
                Matrix(densities.size(), space.displacements()),
                Matrix(displacements.size(), space.displacements()),
                {}};
  const ElementRuns runs(space.mesh());
  const std::vector<bool> mine = myElements(space, algebra);
  GhostNodes ghosts(space, runs, densities.size());
  // Groups of one colour share no node, so that the columns and the transposed rows that
  // they write are different.
  for (int colour = 0; colour < 2; ++colour) {
    // The first groups have the most pairs: first come, first served, from the front.
    const Index count = (runs.size() + 1 - colour) / 2;
    parallelFor(
        {count, workOf(space) / 2, groupsAtOnce(count)},
        [&] {
          return ColumnsOfTiles(runs, mine,
                                TileWriter(space, lame, algebra, out, ghosts));
        },
        [&](ColumnsOfTiles& columns, Index g) {
          columns.assemble(asInt(2 * g + colour));
        });
  }
  ghosts.fold(displacements, out);
  std::vector<int> all(static_cast<std::size_t>(space.mesh().size()));
  std::iota(all.begin(), all.end(), 0);
  const auto add = [&](int e, int i, int f, int k, const Block& block) {
    addBlock(out.doubleLayer, densities, space.density(e, i, 0),
             space.displacement(f, k, 0), block);
  };
  addHalfMass(space.mesh(), all, add);
  addEdgeEnds(space.mesh(), lame, all, all, add);
  out.tractions = ProjectedTractions(space, lame, algebra, tractionElements).finish();
  return out;
}

}  // namespace epafi::bem
