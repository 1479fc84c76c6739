#include "bem/operators/TileWriter.hpp"

#include "bem/operators/Block.hpp"
#include "bem/simd/Dispatch.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

using Stretch = TileWriter::Stretch;

constexpr Index cacheLine = 8;  // doubles
constexpr int forWriting = 1;

struct Addition {
  const std::vector<Stretch>& stretches;

  template <Division>
  EPAFI_INLINE void run() const {
    for (const auto& [to, from, size, scale] : stretches) {
      // the next run's rows: this column comes again when the group is through
      for (Index k = 0; k < size; k += cacheLine)
        __builtin_prefetch(to + size + k, forWriting);
      for (Index k = 0; k < size; ++k)
        to[k] += scale * from[k];
    }
  }
};

}  // namespace

GhostNodes::GhostNodes(const Space& space, const ElementRuns& runs) {
  for (int r = 0; r < runs.size(); ++r)
    if (runs[r].closesLoop)
      first.push_back(space.displacement(runs[r].last - 1, 1, 0));
  const auto ghosts = static_cast<Index>(2 * first.size());
  doubleLayer = Matrix(space.densities(), ghosts);
  hypersingular = Matrix(space.displacements() + ghosts, ghosts);
}

void GhostNodes::fold(Operators& out) const {
  const Index displacements = out.doubleLayer.columns();
  const auto real = [&](Index row) {
    return row < displacements
               ? row
               : first[static_cast<std::size_t>((row - displacements) / 2)] + row % 2;
  };
  for (Index ghost = 0; ghost < doubleLayer.columns(); ++ghost) {
    const Index node = first[static_cast<std::size_t>(ghost / 2)];
    const Index column = node + ghost % 2;
    for (Index row = 0; row < doubleLayer.rows(); ++row)
      out.doubleLayer(row, column) += doubleLayer(row, ghost);
    for (Index from = 0; from < hypersingular.rows(); ++from) {
      const double value = hypersingular(from, ghost);
      const Index row = real(from);
      if (row / 2 != node / 2) {
        out.hypersingular(std::max(row, column), std::min(row, column)) += value;
        continue;
      }
      out.hypersingular(row, column) += value;
      if (from < displacements)  // <W φ, g> and <W g, φ>
        out.hypersingular(column, row) += value;
    }
  }
}

TileWriter::TileWriter(const Space& space, Operators& out, GhostNodes& ghosts)
    : space_(space), out_(out), ghosts_(ghosts) {}

void TileWriter::begin(const ElementLanes& group, const ElementLanes& run) {
  group_ = &group;
  run_ = &run;
  groupStart_ = space_.density(group.first, 0, 0);
  const int last = group.last - 1;
  groupSize_ = space_.density(last, space_.mesh()[last].densities, 0) - groupStart_;
  isEmpty_ = true;
}

void TileWriter::append(Matrix& matrix, Index first, Index column, const double* from,
                        Index size, double scale) {
  // in its place: copying a fresh one by wider words than it was written by waits for these
  Stretch& stretch = stretches_.emplace_back();
  stretch.to = matrix.column(column) + first;
  stretch.from = from;
  stretch.size = size;
  stretch.scale = scale;
}

void TileWriter::add(const PairColumns& columns) {
  const int f = columns.trial();
  const Element& element = space_.mesh()[f];
  const Index densities = space_.density(run_->first, 0, 0);
  stretches_.clear();
  for (int c = 0; c < 2; ++c) {
    for (int i = 0; i < element.densities; ++i)
      append(out_.singleLayer, densities, space_.density(f, i, c),
             columns.singleLayer(i, c), columns.densities(), 1);
    for (int k = 0; k <= element.degree; ++k) {
      const bool isGhost = k == 1 && element.next != f + 1;
      append(isGhost ? ghosts_.doubleLayer : out_.doubleLayer, densities,
             isGhost ? 2 * group_->loop + c : space_.displacement(f, k, c),
             columns.doubleLayer(k, c), columns.densities(), 1);
      appendHypersingular(columns, f, k, c);
    }
  }
  dispatch(largestInstructionSet(), Addition{stretches_});
  if (element.next == f + 1 && f + 1 < run_->last && run_->first <= f + 1)
    addCommonNode(f, columns.commonNode(f + 1 - run_->first));
  collect(columns, f);
}

void TileWriter::appendHypersingular(const PairColumns& columns, int f, int k, int c) {
  const auto [from, scale] = columns.hypersingular(k, c);
  const Index first = space_.displacement(run_->first, 0, 0);
  const Index ends = columns.displacements() - 2;
  const Index inARow = run_->closesLoop ? ends : ends + 2;
  const bool closes = space_.mesh()[f].next != f + 1;
  const bool isGhost = k == 1 && closes;
  const Index column = isGhost ? 2 * group_->loop + c : space_.displacement(f, k, c);
  append(isGhost ? ghosts_.hypersingular : out_.hypersingular, first, column, from,
         inARow, scale);
  // f with itself comes with its ghost's columns
  if (!run_->closesLoop || (closes && !isGhost && run_->last == f + 1))
    return;
  for (Index a = 0; a < 2; ++a) {
    const Index ghost = 2 * run_->loop + a;
    (isGhost ? ghosts_.hypersingular(space_.displacements() + ghost, column)
             : ghosts_.hypersingular(column, ghost)) += scale * from[ends + a];
  }
}

// The node between f and the element behind it has both <W φ, ψ> and <W ψ, φ>.
void TileWriter::addCommonNode(int f, const Block& block) {
  const Index node = space_.displacement(f, 1, 0);
  addBlock(out_.hypersingular, node, node, block);
}

void TileWriter::collect(const PairColumns& columns, int f) {
  const Index count = columns.displacements();
  if (isEmpty_)
    collected_.assign(static_cast<std::size_t>(groupSize_ * count), 0.0);
  isEmpty_ = false;
  const Index start = space_.density(f, 0, 0) - groupStart_;
  for (int i = 0; i < space_.mesh()[f].densities; ++i) {
    const double* x = columns.transposed(i, 0);
    const double* y = columns.transposed(i, 1);
    double* to = collected_.data() + start + 2 * i;
    for (Index k = 0; k < count; ++k, to += groupSize_) {
      to[0] = x[k];
      to[1] = y[k];
    }
  }
}

void TileWriter::finish() {
  if (isEmpty_)
    return;
  const Index first = space_.displacement(run_->first, 0, 0);
  const Index ends = static_cast<Index>(collected_.size()) / groupSize_ - 2;
  stretches_.clear();
  for (Index k = 0; k < ends + 2; ++k) {
    const bool isGhost = run_->closesLoop && k >= ends;
    append(isGhost ? ghosts_.doubleLayer : out_.doubleLayer, groupStart_,
           isGhost ? 2 * run_->loop + k - ends : first + k,
           collected_.data() + k * groupSize_, groupSize_, 1);
  }
  dispatch(largestInstructionSet(), Addition{stretches_});
}

}  // namespace epafi::bem
