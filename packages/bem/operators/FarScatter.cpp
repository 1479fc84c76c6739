#include "bem/operators/FarScatter.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

using Stretch = FarScatter::Stretch;

constexpr Index cacheLine = 8;  // doubles
constexpr int forWriting = 1;

EPAFI_INLINE void addAll(const Stretch* stretches, std::size_t count) {
  for (std::size_t s = 0; s < count; ++s) {
    const auto [to, from, size, scale] = stretches[s];
    // the next run's rows: this column comes again when the group is through
    for (Index k = 0; k < size; k += cacheLine)
      __builtin_prefetch(to + size + k, forWriting);
    for (Index k = 0; k < size; ++k)
      to[k] += scale * from[k];
  }
}

EPAFI_AVX512 void addAvx512(const Stretch* stretches, std::size_t count) {
  addAll(stretches, count);
}

EPAFI_AVX2 void addAvx2(const Stretch* stretches, std::size_t count) {
  addAll(stretches, count);
}

void addBaseline(const Stretch* stretches, std::size_t count) {
  addAll(stretches, count);
}

void addStretches(const std::vector<Stretch>& stretches) {
  switch (largestInstructionSet()) {
    case InstructionSet::Avx512:
      return addAvx512(stretches.data(), stretches.size());
    case InstructionSet::Avx2:
      return addAvx2(stretches.data(), stretches.size());
    case InstructionSet::Baseline:
      return addBaseline(stretches.data(), stretches.size());
  }
}

}  // namespace

FarScatter::FarScatter(const Space& space, const Lame& lame, const DenseAlgebra& algebra,
                       Operators& out)
    : space_(space),
      densityRows_(algebra.myRows(space.densities())),
      displacementRows_(algebra.myRows(space.displacements())),
      out_(out),
      blocks_(space, lame) {
  for (int k = 0; k <= largestDegree; ++k)
    slopes_[static_cast<std::size_t>(k)] = DisplacementBasis::slope(k);
}

void FarScatter::begin(const ElementRange& group, const ElementRun& run) {
  run_ = &run;
  groupStart_ = space_.density(group.first, 0, 0);
  const int last = group.last - 1;
  groupSize_ = space_.density(last, space_.mesh()[last].degree, 0) - groupStart_;
  front_ = std::max(run.first, group.first);
  isEmpty_ = true;
  blocks_.setRun(run);
}

void FarScatter::append(const Target& target, Index first, Index column,
                        const double* from, Index size, double scale) {
  const Index begin = std::max(first, target.mine.begin);
  const Index end = std::min(first + size, target.mine.end);
  if (begin < end)
    stretches_.push_back({target.matrix.column(column) + (begin - target.mine.begin),
                          from + (begin - first), end - begin, scale});
}

const FarBlocks& FarScatter::add(int f, const FarLanes& chosen, const FarBatch& batch) {
  blocks_.evaluate(f, chosen, batch);
  const int degree = space_.mesh()[f].degree;
  const Index densities = space_.density(front_, 0, 0);
  const Index displacements = space_.displacement(front_, 0, 0);
  const Index skip = densities - space_.density(run_->first, 0, 0);
  const Index rows = blocks_.densities() - skip;
  const Target single = {out_.singleLayer, densityRows_};
  const Target twice = {out_.doubleLayer, densityRows_};
  const Target hypersingular = {out_.hypersingular, displacementRows_};
  stretches_.clear();
  for (int c = 0; c < 2; ++c) {
    for (int i = 0; i < degree; ++i)
      append(single, densities, space_.density(f, i, c), blocks_.singleLayer(i, c) + skip,
             rows, 1);
    for (int k = 0; k <= degree; ++k) {
      const Index column = space_.displacement(f, k, c);
      append(twice, densities, column, blocks_.doubleLayer(k, c) + skip, rows, 1);
      append(hypersingular, displacements, column,
             blocks_.slopeLayer(std::max(k - 1, 0), c) + skip, rows + 2,
             slopes_[static_cast<std::size_t>(k)]);
    }
  }
  addStretches(stretches_);
  collect(f);
  return blocks_;
}

void FarScatter::collect(int f) {
  const Index columns = blocks_.displacements();
  if (isEmpty_)
    collected_.assign(static_cast<std::size_t>(groupSize_ * columns), 0.0);
  isEmpty_ = false;
  const Index start = space_.density(f, 0, 0) - groupStart_;
  for (int i = 0; i < space_.mesh()[f].degree; ++i) {
    const double* x = blocks_.transposed(i, 0);
    const double* y = blocks_.transposed(i, 1);
    double* to = collected_.data() + start + 2 * i;
    for (Index k = 0; k < columns; ++k, to += groupSize_) {
      to[0] = x[k];
      to[1] = y[k];
    }
  }
}

void FarScatter::finish() {
  if (isEmpty_)
    return;
  const Target target = {out_.doubleLayer, densityRows_};
  const Index first = space_.displacement(run_->first, 0, 0);
  const Index last =
      std::min<Index>(first + blocks_.displacements(), space_.displacements());
  stretches_.clear();
  for (Index column = space_.displacement(front_, 0, 0); column < last; ++column)
    append(target, groupStart_, column, collected_.data() + (column - first) * groupSize_,
           groupSize_, 1);
  addStretches(stretches_);
}

}  // namespace epafi::bem
