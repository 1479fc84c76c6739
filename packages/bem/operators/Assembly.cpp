#include "bem/operators/Assembly.hpp"

#include "bem/moments/NearPair.hpp"
#include "bem/moments/PairBatch.hpp"
#include "bem/operators/FarScatter.hpp"
#include "bem/operators/MyElements.hpp"
#include "bem/operators/Scatter.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace epafi::bem {

namespace {

/// Does this element end where its loop begins?  The node behind it is numbered apart.
bool closesItsLoop(const Mesh& mesh, int e) { return mesh[e].next != e + 1; }

/// What all threads share.
struct Shared {
  const Space& space;
  const ElementRuns& runs;
  const MyElements& mine;
  const Scatter& scatter;
  ProjectedTractions& tractions;

  void addNear(int e, int f, const PairMoments& moments) const {
    scatter.add(e, f, moments);
    tractions.addNear(e, f, moments);
  }
};

/// The pairs (e, f) with f <= e and f in a group, one thread's.
class ColumnsOfPairs {
 public:
  ColumnsOfPairs(const Shared& shared, FarScatter farScatter)
      : far_(std::move(farScatter)),
        shared_(shared),
        near_(std::make_unique<PairMoments>()),
        lane_(std::make_unique<FarMoments>()) {}

  /// Run by run for all f of the group: the rows that they write stay in cache.
  void assemble(const ElementRange& group) {
    for (int r = group.first / lanes; r < shared_.runs.size(); ++r) {
      far_.begin(group, shared_.runs[r]);
      for (int f = group.first; f < group.last; ++f)
        if (f < shared_.runs[r].last)
          assembleRun(f, r);
      far_.finish();
    }
  }

 private:
  // The whole batch or nothing: results shall not depend on the number of processes.
  void assembleRun(int f, int r) {
    const ElementRun& run = shared_.runs[r];
    const ElementRange wanted = {std::max(f, run.first), run.last};
    if (!isMine(f, wanted))
      return;
    const Mesh& mesh = shared_.space.mesh();
    FarLanes chosen = shared_.runs.choose(f, r, wanted, batch_);
    for (int e = wanted.first; e < wanted.last; ++e) {
      bool& isFar = chosen.far[e - run.first];
      if (e != f && closesItsLoop(mesh, e)) {
        chosen.count -= isFar ? 1 : 0;
        isFar = false;  // comes with assembleClosingRow
      } else if (!isFar && isMine(f, {e, e + 1})) {
        nearMoments_.evaluate(mesh, e, f, *lane_, 0);
        extractLane(*lane_, 0, mesh[f].tangent, mesh[e].degree, mesh[f].degree, *near_);
        shared_.addNear(e, f, *near_);
      }
    }
    if (chosen.count == 0)
      return;
    const FarBlocks& blocks = far_.add(f, chosen, batch_);
    for (int e = wanted.first; e < wanted.last; ++e)
      if (chosen.far[e - run.first] && mesh[e].piece.edge == mesh[f].piece.edge) {
        const FarBlocks::Phase phase = blocks.phase(e - run.first);
        shared_.scatter.addTurning(e, f, phase.real, phase.imag);
      }
  }

  bool isMine(int f, const ElementRange& others) const {
    bool mine = shared_.mine.contain(f);
    for (int e = others.first; e < others.last; ++e)
      mine = mine || shared_.mine.contain(e);
    return mine;
  }

  FarBatch batch_{};
  FarScatter far_;
  const Shared& shared_;
  NearMoments nearMoments_;
  std::unique_ptr<PairMoments> near_;
  std::unique_ptr<FarMoments> lane_;
};

/// The pairs (e, f) with f < e of an element e that closes its loop, one by one.
void assembleClosingRow(int e, const Shared& shared) {
  PairBatch batch(shared.runs);
  for (int r = 0; r * lanes < e; ++r) {
    const ElementRun& run = shared.runs[r];
    const ElementRange wanted = {run.first, std::min(run.last, e)};
    batch.choose(e, r, wanted);
    for (int f = wanted.first; f < wanted.last; ++f) {
      if (!shared.mine.contain(e) && !shared.mine.contain(f))
        continue;
      const PairMoments& moments = batch.at(f);
      shared.scatter.add(e, f, moments);
      if (!batch.isFar(f))
        shared.tractions.addNear(e, f, moments);
    }
  }
}

/// The elements f in groups: two groups of one colour share no node, so that the columns
/// and the transposed rows that they write are different.  Elements that close their loop
/// share nodes with what is far from them in the numbering: each is on its own.
struct Groups {
  std::array<std::vector<ElementRange>, 2> colours;
  std::vector<int> closing;
};

Groups groupsOf(const Mesh& mesh) {
  constexpr int largest = 8;
  Groups groups;
  std::size_t colour = 0;
  ElementRange group;
  const auto end = [&](int last) {
    group.last = last;
    if (group.first < last)
      groups.colours[colour].push_back(group);
    group.first = last;
    colour = 1 - colour;
  };
  for (int e = 0; e < mesh.size(); ++e)
    if (closesItsLoop(mesh, e)) {
      end(e);
      groups.closing.push_back(e);
      group.first = e + 1;
    } else if (e + 1 - group.first == largest) {
      end(e + 1);
    }
  return groups;
}

/// Groups that a thread takes at once: a few, since a huge page has the columns of
/// several, and two threads that meet in a new one both clear it.
int groupsAtOnce(int count) { return std::clamp(count / 8, 1, 4); }

}  // namespace

Operators assembleOperators(const Space& space, const Lame& lame,
                            const DenseAlgebra& algebra,
                            const std::vector<int>& tractionElements) {
  const Index densities = algebra.myRows(space.densities()).size();
  const Index displacements = algebra.myRows(space.displacements()).size();
  Operators out{Matrix(densities, space.densities()),
                Matrix(densities, space.displacements()),
                Matrix(displacements, space.displacements()),
                {}};
  const Scatter scatter(space, lame, algebra, out);
  ProjectedTractions tractions(space, lame, algebra, tractionElements);
  const ElementRuns runs(space.mesh());
  const MyElements mine(space, algebra);
  const Shared shared = {space, runs, mine, scatter, tractions};
  const Groups groups = groupsOf(space.mesh());
#pragma omp parallel
  {
    ColumnsOfPairs columns(shared, FarScatter(space, lame, algebra, out));
    for (const auto& colour : groups.colours) {
      // The first groups have the most pairs: first come, first served, from the front.
      const int count = static_cast<int>(colour.size());
#pragma omp for schedule(dynamic, groupsAtOnce(count))
      for (int g = 0; g < count; ++g)
        columns.assemble(colour[static_cast<std::size_t>(g)]);
    }
#pragma omp single
    for (const int e : groups.closing) {
      columns.assemble({e, e + 1});
      assembleClosingRow(e, shared);
    }
  }
  out.tractions = tractions.finish();
  return out;
}

}  // namespace epafi::bem
