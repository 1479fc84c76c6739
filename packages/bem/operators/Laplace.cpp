#include "bem/operators/Laplace.hpp"

#include "bem/algebra/SmallAlgebra.hpp"
#include "bem/moments/Tile.hpp"
#include "bem/operators/LocalTerms.hpp"

#include <algorithm>
#include <numeric>

namespace epafi::bem {

namespace {

constexpr double twoPi = 6.283185307179586;

Vector partOf(const Vector& x, const std::vector<Index>& which) {
  Vector part;
  for (const Index i : which)
    part.push_back(x[at(i)]);
  return part;
}

void put(const Vector& part, const std::vector<Index>& which, Vector& x) {
  for (std::size_t k = 0; k < which.size(); ++k)
    x[at(which[k])] = part[k];
}

/// <P_i on one element, K of the other's functions> from its Legendre moments, `moments(j)`.
template <class Moments, class Add>
void addFunctions(const Element& source, const Moments& moments, const Add& add) {
  const Matrix coefficients = DisplacementBasis::legendreCoefficients(source.degree);
  for (int k = 0; k <= source.degree; ++k) {
    double sum = 0;
    for (int j = 0; j <= source.degree; ++j)
      sum += coefficients(j, k) * moments(j);
    add(k, sum);
  }
}

}  // namespace

MixedLaplace::MixedLaplace(const Space& space, const std::vector<bool>& isPotentialGiven)
    : space_(space),
      single_(space.densities() / 2, space.densities() / 2),
      double_(space.densities() / 2, space.displacements() / 2) {
  assemble();
  findFreeLoops(isPotentialGiven);
  const Mesh& mesh = space.mesh();
  std::vector<bool> isGiven(at(double_.columns()), false);
  for (int e = 0; e < mesh.size(); ++e)
    for (int k = 0; k <= mesh[e].degree; ++k)
      if (isPotentialGiven[at(e)])
        isGiven[at(HarmonicData::potentialOf(space, e, k))] = true;
  for (Index j = 0; j < double_.columns(); ++j)
    if (!isGiven[at(j)])
      unknownPotentials_.push_back(j);
  for (int e = 0; e < mesh.size(); ++e)
    for (int i = 0; i < mesh[e].densities && isPotentialGiven[at(e)]; ++i)
      unknownFlows_.push_back(HarmonicData::flowOf(space, e, i));
  const auto flows = static_cast<Index>(unknownFlows_.size());
  const auto potentials = static_cast<Index>(unknownPotentials_.size());
  Matrix v(flows, flows);
  Matrix k(flows, potentials);
  for (Index i = 0; i < flows; ++i) {
    for (Index j = 0; j < flows; ++j)
      v(i, j) = single_(unknownFlows_[at(i)], unknownFlows_[at(j)]);
    for (Index j = 0; j < potentials; ++j)
      k(i, j) = double_(unknownFlows_[at(i)], unknownPotentials_[at(j)]);
  }
  flows_.emplace(std::move(v), "the single layer potential of heat");
  if (potentials == 0)
    return;
  response_ = flows_->forward(std::move(k));
  // W of unknown potentials, each of which has a slope on one element or two
  std::vector<std::vector<Entry>> slopes(at(double_.columns()));
  for (const Entry& entry : slopes_)
    slopes[at(entry.column)].push_back(entry);
  Matrix w(potentials, potentials);
  for (Index j = 0; j < potentials; ++j)
    for (Index i = j; i < potentials; ++i)
      for (const Entry& a : slopes[at(unknownPotentials_[at(i)])])
        for (const Entry& b : slopes[at(unknownPotentials_[at(j)])])
          w(i, j) += a.value * b.value * single_(a.row, b.row);
  for (const FreeLoop& loop : freeLoops_) {
    const Vector mean = partOf(meanOf(loop), unknownPotentials_);
    for (Index j = 0; j < potentials; ++j)
      for (Index i = j; i < potentials; ++i)
        w(i, j) += mean[at(i)] * mean[at(j)];
  }
  potentials_.emplace(addGram(std::move(w), response_), "the operator of heat");
}

void MixedLaplace::assemble() {
  const Mesh& mesh = space_.mesh();
  const ElementRuns runs(mesh);
  Tile tile(runs);
  const auto flow = [&](int e, int i) { return HarmonicData::flowOf(space_, e, i); };
  const auto potential = [&](int e, int k) {
    return HarmonicData::potentialOf(space_, e, k);
  };
  const auto addPair = [&](int e, int f, int lane) {
    constexpr int stride = TileMoments::stride;
    const TileMoments& m = tile.moments();
    const Element& x = mesh[e];
    const Element& y = mesh[f];
    for (int i = 0; i < x.densities; ++i)
      for (int j = 0; j < y.densities; ++j)
        single_(flow(e, i), flow(f, j)) = single_(flow(f, j), flow(e, i)) =
            -x.half * y.half / twoPi * m.log[i * stride + j][lane];
    if (x.piece.edge == y.piece.edge && x.curve.isStraight())
      return;
    for (int i = 0; i < x.densities; ++i)
      addFunctions(
          y, [&](int j) { return m.direct[i * stride + j][lane]; },
          [&](int k, double sum) {
            double_(flow(e, i), potential(f, k)) += x.half / twoPi * sum;
          });
    for (int j = 0; j < y.densities && e != f; ++j)
      addFunctions(
          x, [&](int i) { return m.reverse[i * stride + j][lane]; },
          [&](int k, double sum) {
            double_(flow(f, j), potential(e, k)) += y.half / twoPi * sum;
          });
  };
  for (int e = 0; e < mesh.size(); ++e)
    for (int r = runs.runOf(e); r < runs.size(); ++r) {
      const ElementRange wanted{std::max(e, runs[r].first), runs[r].last};
      tile.evaluate(e, r, wanted);
      for (int f = wanted.first; f < wanted.last; ++f)
        addPair(e, f, f - runs[r].first);
    }
  std::vector<int> all(at(mesh.size()));
  std::iota(all.begin(), all.end(), 0);
  addHalfMass(mesh, all, [&](int e, int i, int f, int k, const Block& block) {
    half_.push_back({flow(e, i), potential(f, k), block.xx});
    double_(flow(e, i), potential(f, k)) += block.xx;
  });
  for (int e = 0; e < mesh.size(); ++e)
    for (int k = 0; k <= mesh[e].degree; ++k)
      slopes_.push_back({flow(e, std::max(k - 1, 0)), potential(e, k),
                         DisplacementBasis::slope(k) / mesh[e].half});
}

void MixedLaplace::findFreeLoops(const std::vector<bool>& isPotentialGiven) {
  const Mesh& mesh = space_.mesh();
  std::vector<FreeLoop> loops(at(mesh.outline().loops()));
  std::vector<bool> isFree(loops.size(), true);
  for (int e = 0; e < mesh.size(); ++e) {
    const std::size_t k = at(mesh.outline().edge(mesh[e].piece.edge).loop);
    isFree[k] = isFree[k] && k > 0 && !isPotentialGiven[at(e)];
    loops[k].flows.push_back(HarmonicData::flowOf(space_, e, 0));
    loops[k].nodes.push_back(HarmonicData::potentialOf(space_, e, 0));
    loops[k].length += 2 * mesh[e].half;
  }
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (isFree[k])
      freeLoops_.push_back(loops[k]);
}

/// ∫ φ over a loop, over its length.
Vector MixedLaplace::meanOf(const FreeLoop& loop) const {
  Vector result(at(double_.columns()));
  for (const auto& [row, column, value] : half_)
    if (std::find(loop.flows.begin(), loop.flows.end(), row) != loop.flows.end())
      result[at(column)] += 2 / loop.length * value;
  return result;
}

Vector MixedLaplace::slopeOf(const Vector& potential) const {
  Vector result(at(single_.rows()));
  for (const auto& [row, column, value] : slopes_)
    result[at(row)] += value * potential[at(column)];
  return result;
}

Vector MixedLaplace::transposedSlopeOf(const Vector& flow) const {
  Vector result(at(double_.columns()));
  for (const auto& [row, column, value] : slopes_)
    result[at(column)] += value * flow[at(row)];
  return result;
}

// With T and q what is given, zero elsewhere:
//   V q' - (K + 1/2) T' = (K + 1/2) T - V q,   (K + 1/2)ᵀ q' + W T' = <q, φ> - (K + 1/2)ᵀ q - W T
HarmonicData MixedLaplace::solve(const HarmonicData& given) const {
  HarmonicData all = given;
  for (const Index j : unknownPotentials_)
    all.potential[at(j)] = 0;
  for (const Index i : unknownFlows_)
    all.flow[at(i)] = 0;
  Vector first = multiply(double_, all.potential);
  axpy(-1, multiply(single_, all.flow), first);
  first = columnOf(flows_->forward(asColumn(partOf(first, unknownFlows_))), 0);
  if (potentials_) {
    Vector second = transposedSlopeOf(multiply(single_, slopeOf(all.potential)));  // W T
    axpy(1, columnOf(transposedTimes(double_, asColumn(all.flow)), 0), second);
    for (const auto& [row, column, value] : half_)
      second[at(column)] -= 2 * value * all.flow[at(row)];
    second = partOf(second, unknownPotentials_);
    axpy(1, columnOf(transposedTimes(response_, asColumn(first)), 0), second);
    for (double& x : second)
      x = -x;
    const Vector potentials = potentials_->solve(second);
    put(potentials, unknownPotentials_, all.potential);
    axpy(1, multiply(response_, potentials), first);
  }
  put(flows_->backward(first), unknownFlows_, all.flow);
  if (freeLoops_.empty())
    return all;
  Vector missed = multiply(single_, all.flow);
  axpy(-1, multiply(double_, all.potential), missed);
  for (const FreeLoop& loop : freeLoops_) {
    double sum = 0;
    for (const Index i : loop.flows)
      sum += missed[at(i)];
    for (const Index j : loop.nodes)
      all.potential[at(j)] += sum / loop.length;
  }
  return all;
}

}  // namespace epafi::bem
