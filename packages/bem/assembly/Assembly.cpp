#include "bem/assembly/Assembly.hpp"

#include "bem/assembly/MyElements.hpp"
#include "bem/assembly/PairBatch.hpp"
#include "bem/assembly/Scatter.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

/// All pairs (e, f) with f <= e, e in a group, of which a row is mine.
class RowOfPairs {
 public:
  RowOfPairs(const Space& space, const DenseAlgebra& algebra, const Scatter& scatter,
             ProjectedTractions& tractions)
      : mine_(space, algebra), scatter_(scatter), tractions_(tractions) {}

  /// Batch by batch for all e of a group: the columns that a batch writes stay in cache.
  void assemble(const std::vector<int>& group, PairBatch& batch) const {
    for (int first = 0; first <= group.back(); first += lanes)
      for (const int e : group)
        if (first <= e)
          assembleBatch(e, first, std::min(first + lanes, e + 1), batch);
  }

 private:
  // The whole batch or nothing: results shall not depend on the number of processes.
  void assembleBatch(int e, int first, int last, PairBatch& batch) const {
    if (!isMine(e, first, last))
      return;
    batch.choose(e, first / lanes, last);
    for (int f = first; f < last; ++f) {
      if (!isMine(e, f, f + 1))
        continue;
      const PairMoments& moments = batch.at(f);
      scatter_.add(e, f, moments);
      if (!batch.isFar(f))
        tractions_.addNear(e, f, moments);
    }
  }

  bool isMine(int e, int first, int last) const {
    bool mine = mine_.contain(e);
    for (int f = first; f < last; ++f)
      mine = mine || mine_.contain(f);
    return mine;
  }

  MyElements mine_;
  const Scatter& scatter_;
  ProjectedTractions& tractions_;
};

/// Groups of elements that threads may treat at once: two groups of the same colour share
/// no node, so their columns of K and rows of W are different.
std::vector<std::vector<std::vector<int>>> colouredGroups(const Mesh& mesh) {
  constexpr int groupSize = 8;
  std::vector<std::vector<std::vector<int>>> colours(2);
  std::vector<int> current;
  int colour = 0;
  for (int e = 0; e < mesh.size(); ++e) {
    if (mesh[e].next != e + 1) {  // closes its loop: on its own
      colours.push_back({{e}});
      continue;
    }
    current.push_back(e);
    if (static_cast<int>(current.size()) == groupSize) {
      colours[colour].push_back(current);
      current.clear();
      colour = 1 - colour;
    }
  }
  if (!current.empty())
    colours[colour].push_back(current);
  return colours;
}

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
  const RowOfPairs row(space, algebra, scatter, tractions);
#pragma omp parallel
  {
    PairBatch batch(runs);
    for (const auto& groups : colouredGroups(space.mesh())) {
      // the last groups have the most pairs: first come, first served, from the back
#pragma omp for schedule(dynamic, 1)
      for (int g = static_cast<int>(groups.size()) - 1; g >= 0; --g)
        row.assemble(groups[static_cast<std::size_t>(g)], batch);
    }
  }
  out.tractions = tractions.finish();
  return out;
}

}  // namespace epafi::bem
