#include "bem/operators/TileWriter.hpp"

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

GhostNodes::GhostNodes(const Space& space, const ElementRuns& runs)
    : components(space.components()) {
  for (int r = 0; r < runs.size(); ++r)
    if (runs[r].closesLoop)
      first.push_back(space.displacement(runs[r].last - 1, 1, 0));
  const auto ghosts = components * static_cast<Index>(first.size());
  doubleLayer = Matrix(space.densities(), ghosts);
  hypersingular = Matrix(space.displacements() + ghosts, ghosts);
}

void GhostNodes::fold(Operators& out) const {
  const Index displacements = out.doubleLayer.columns();
  const auto real = [&](Index row) {
    return row < displacements ? row
                               : first[at((row - displacements) / components)] +
                                     (row - displacements) % components;
  };
  for (Index ghost = 0; ghost < doubleLayer.columns(); ++ghost) {
    const Index node = first[at(ghost / components)];
    const Index column = node + ghost % components;
    for (Index row = 0; row < doubleLayer.rows(); ++row)
      out.doubleLayer(row, column) += doubleLayer(row, ghost);
    for (Index from = 0; from < hypersingular.rows(); ++from) {
      const double value = hypersingular(from, ghost);
      const Index row = real(from);
      if (row / components != node / components) {
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
  for (int c = 0; c < columns.components(); ++c) {
    for (int i = 0; i < element.densities; ++i)
      append(out_.singleLayer, densities, space_.density(f, i, c),
             columns.singleLayer(i, c), columns.densities(), 1);
    for (int k = 0; k <= element.degree; ++k) {
      const bool isGhost = k == 1 && element.next != f + 1;
      append(isGhost ? ghosts_.doubleLayer : out_.doubleLayer, densities,
             isGhost ? columns.components() * group_->loop + c
                     : space_.displacement(f, k, c),
             columns.doubleLayer(k, c), columns.densities(), 1);
      appendHypersingular(columns, f, k, c);
    }
  }
  dispatch(Addition{stretches_});
  if (element.next == f + 1 && f + 1 < run_->last && run_->first <= f + 1)
    addCommonNode(f, columns);
  collect(columns, f);
}

void TileWriter::appendHypersingular(const PairColumns& columns, int f, int k, int c) {
  const auto [from, scale] = columns.hypersingular(k, c);
  const Index first = space_.displacement(run_->first, 0, 0);
  const int components = columns.components();
  const Index ends = columns.displacements() - components;
  const Index inARow = run_->closesLoop ? ends : ends + components;
  const bool closes = space_.mesh()[f].next != f + 1;
  const bool isGhost = k == 1 && closes;
  const Index column =
      isGhost ? components * group_->loop + c : space_.displacement(f, k, c);
  append(isGhost ? ghosts_.hypersingular : out_.hypersingular, first, column, from,
         inARow, scale);
  // f with itself comes with its ghost's columns
  if (!run_->closesLoop || (closes && !isGhost && run_->last == f + 1))
    return;
  for (Index a = 0; a < components; ++a) {
    const Index ghost = components * run_->loop + a;
    (isGhost ? ghosts_.hypersingular(space_.displacements() + ghost, column)
             : ghosts_.hypersingular(column, ghost)) += scale * from[ends + a];
  }
}

// The node between f and the element behind it has both <W φ, ψ> and <W ψ, φ>.
void TileWriter::addCommonNode(int f, const PairColumns& columns) {
  const Index node = space_.displacement(f, 1, 0);
  const int lane = f + 1 - run_->first;
  for (int d = 0; d < columns.components(); ++d)
    for (int c = 0; c < columns.components(); ++c)
      out_.hypersingular(node + c, node + d) += columns.commonNode(lane, c, d);
}

void TileWriter::collect(const PairColumns& columns, int f) {
  const Index count = columns.displacements();
  if (isEmpty_)
    collected_.assign(static_cast<std::size_t>(groupSize_ * count), 0.0);
  isEmpty_ = false;
  const Index start = space_.density(f, 0, 0) - groupStart_;
  for (int i = 0; i < space_.mesh()[f].densities; ++i) {
    const int components = columns.components();
    const double* x = columns.transposed(i, 0);
    const double* y = columns.transposed(i, components - 1);
    double* to = collected_.data() + start + components * i;
    for (Index k = 0; k < count; ++k, to += groupSize_) {
      to[0] = x[k];
      to[components - 1] = y[k];
    }
  }
}

void TileWriter::finish() {
  if (isEmpty_)
    return;
  const Index first = space_.displacement(run_->first, 0, 0);
  const Index ends =
      static_cast<Index>(collected_.size()) / groupSize_ - space_.components();
  stretches_.clear();
  const int components = space_.components();
  for (Index k = 0; k < ends + components; ++k) {
    const bool isGhost = run_->closesLoop && k >= ends;
    append(isGhost ? ghosts_.doubleLayer : out_.doubleLayer, groupStart_,
           isGhost ? components * run_->loop + k - ends : first + k,
           collected_.data() + k * groupSize_, groupSize_, 1);
  }
  dispatch(Addition{stretches_});
}

}  // namespace epafi::bem
