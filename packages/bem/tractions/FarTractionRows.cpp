#include "bem/tractions/FarTractionRows.hpp"

#include "bem/base/Error.hpp"
#include "bem/tractions/FarTractions.hpp"

#include <algorithm>

namespace epafi::bem {

namespace {

using Operator = FarTractions::Operator;

/// The values of a run of sources, to the rows of their densities.
void copyRun(const FarTractions& values, const Space& space, const ElementRun& run,
             const FarLanes& chosen, Operator op, Matrix& columns) {
  const Mesh& mesh = space.mesh();
  const Index start = space.density(run.first, 0, 0);
  const bool inARow = chosen.count == lanes && run.degree == 1;
  for (int i = 0; i < values.moments(); ++i)
    for (int a = 0; a < 2; ++a) {
      double* column = columns.column(2 * i + a);
      if (inARow) {
        std::copy_n(values.at(op, i, 0, a), 2 * lanes, column + start);
        continue;
      }
      for (int lane = 0; lane < run.last - run.first; ++lane) {
        if (!chosen.far[lane])
          continue;
        const int f = run.first + lane;
        for (int j = 0; j < mesh[f].degree; ++j)
          std::copy_n(values.at(op, i, j, a) + 2 * lane, 2,
                      column + space.density(f, j, 0));
      }
    }
}

}  // namespace

FarTractionRows::FarTractionRows(const Space& space, const Lame& lame)
    : space_(space), lame_(lame), runs_(space.mesh()) {
  const Mesh& mesh = space.mesh();
  for (const Element& element : mesh.elements())
    if (element.densities > element.degree)
      throw InputError("tractions of ", element.densities,
                       " functions of a density on an element of degree ", element.degree,
                       "; as many as its degree are possible");
  for (int f = 0; f < mesh.size(); ++f)
    for (int c = 0; c < 2; ++c) {
      appendNode(space.displacement(f, 0, c), space.density(mesh[f].previous, 0, c),
                 space.density(f, 0, c));
      for (int j = 1; j < mesh[f].degree; ++j)
        bubbles_.push_back({space.displacement(f, j + 1, c), space.density(f, j, c),
                            2 * DisplacementBasis::slope(j + 1)});
    }
}

std::vector<int> FarTractionRows::near(int element, int largestOuter) const {
  std::vector<int> result;
  FarBatch batch{};
  for (int r = 0; r < runs_.size(); ++r) {
    const ElementRange all = {runs_[r].first, runs_[r].last};
    const FarLanes chosen = runs_.choose(element, r, all, batch, largestOuter);
    for (int f = all.first; f < all.last; ++f)
      if (!chosen.far[f - all.first])
        result.push_back(f);
  }
  return result;
}

void FarTractionRows::appendNode(Index row, Index onPrevious, Index onNext) {
  const auto follows = [&](const Nodes& n) {
    return row == n.row + n.count && onPrevious == n.onPrevious + n.count &&
           onNext == n.onNext + n.count;
  };
  if (nodes_.empty() || !follows(nodes_.back()))
    nodes_.push_back({row, onPrevious, onNext, 0});
  ++nodes_.back().count;
}

void FarTractionRows::write(int element, int moments, int largestOuter, Index first,
                            Matrix& hypersingular, Matrix& adjoint) const {
  Matrix densities(space_.densities(), 2 * moments);
  Matrix slopes(space_.densities(), 2 * moments);
  const Element& test = space_.mesh()[element];
  FarTractions values(test, lame_, moments);
  FarBatch batch{};
  for (int r = 0; r < runs_.size(); ++r) {
    const ElementRun& run = runs_[r];
    const FarLanes chosen =
        runs_.choose(element, r, {run.first, run.last}, batch, largestOuter);
    if (chosen.count == 0)
      continue;
    if (run.hasArcs || !test.curve.isStraight()) {
      for (int lane = 0; lane < run.last - run.first; ++lane)
        if (chosen.far[lane])
          values.evaluateArc(space_.mesh()[run.first + lane],
                             {batch.wx[lane], batch.wy[lane]}, chosen.own[lane], lane);
    } else {
      values.evaluate(batch, chosen);
    }
    copyRun(values, space_, run, chosen, Operator::Adjoint, densities);
    copyRun(values, space_, run, chosen, Operator::Hypersingular, slopes);
  }
  for (int k = 0; k < 2 * moments; ++k) {
    std::copy_n(densities.column(k), densities.rows(), adjoint.column(first + k));
    gatherSlopes(slopes.column(k), hypersingular.column(first + k));
  }
}

// φ' is 1/h before a node and -1/h behind it
void FarTractionRows::gatherSlopes(const double* slopes, double* column) const {
  for (const Nodes& nodes : nodes_)
    for (Index k = 0; k < nodes.count; ++k)
      column[nodes.row + k] = slopes[nodes.onPrevious + k] - slopes[nodes.onNext + k];
  for (const Bubble& bubble : bubbles_)
    column[bubble.row] = bubble.slope * slopes[bubble.density];
}

}  // namespace epafi::bem
