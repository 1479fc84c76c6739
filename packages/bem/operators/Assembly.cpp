#include "bem/operators/Assembly.hpp"

#include "bem/base/Parallel.hpp"
#include "bem/operators/ExactRotation.hpp"
#include "bem/operators/TileWriter.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace epafi::bem {

namespace {

/// One thread's.
struct Workspace {
  std::unique_ptr<PairColumns> pairs;
  TileWriter writer;

  /// The pairs (e, f) with f <= e and f in a group, run by run for all f of the group: the rows
  /// that they write stay in cache.
  void assemble(const ElementRuns& runs, int group) {
    for (int r = group; r < runs.size(); ++r) {
      writer.begin(runs[group], runs[r]);
      for (int f = runs[group].first; f < runs[group].last; ++f) {
        if (runs.mesh()[f].densities == 0)  // on the axis
          continue;
        pairs->evaluate(runs, f, r, {std::max(f, runs[r].first), runs[r].last});
        writer.add(*pairs);
      }
      writer.finish();
    }
  }
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

Operators assemblePolynomialOperators(const Space& space, const Kernel& kernel) {
  Operators out{Matrix(space.densities(), space.densities()),
                Matrix(space.densities(), space.displacements()),
                Matrix(space.displacements(), space.displacements())};
  const ElementRuns runs(space.mesh());
  GhostNodes ghosts(space, runs);
  // Groups of one colour share no node, so that the columns and the transposed rows that
  // they write are different.
  for (int colour = 0; colour < 2; ++colour) {
    // The first groups have the most pairs: first come, first served, from the front.
    const Index count = (runs.size() + 1 - colour) / 2;
    parallelFor(
        {count, workOf(space) / 2, groupsAtOnce(count)},
        [&] {
          return Workspace{kernel.pairs(space), TileWriter(space, out, ghosts)};
        },
        [&](Workspace& own, Index g) { own.assemble(runs, asInt(2 * g + colour)); });
  }
  ghosts.fold(out);
  return out;
}

Operators assembleOperators(const Space& space, const Kernel& kernel) {
  return withExactRotation(assemblePolynomialOperators(space, kernel), space);
}

}  // namespace epafi::bem
