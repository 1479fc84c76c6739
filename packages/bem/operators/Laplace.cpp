#include "bem/operators/Laplace.hpp"

#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/operators/Assembly.hpp"
#include "bem/operators/LocalFunctions.hpp"

#include <algorithm>
#include <cassert>

namespace epafi::bem {

MixedLaplace::MixedLaplace(const Space& space, const std::vector<bool>& isPotentialGiven)
    : all_((space.densities() + space.displacements()) / 2,
           (space.densities() + space.displacements()) / 2) {
  assert(std::count(isPotentialGiven.begin(), isPotentialGiven.end(), true) > 0);
  assert(std::all_of(space.mesh().elements().begin(), space.mesh().elements().end(),
                     [](const Element& e) { return e.densities == e.degree; }));
  assemble(space);
  holdConstants(space, isPotentialGiven);
  const Mesh& mesh = space.mesh();
  std::vector<bool> isUnknown(at(all_.rows()), false);
  std::fill(isUnknown.begin() + space.densities() / 2, isUnknown.end(), true);
  for (int e = 0; e < mesh.size(); ++e)
    if (isPotentialGiven[at(e)]) {
      for (int k = 0; k <= mesh[e].degree; ++k)
        isUnknown[at(potentialOf(space, e, k))] = false;
      for (int i = 0; i < mesh[e].densities; ++i)
        isUnknown[at(flowOf(space, e, i))] = true;
    }
  for (Index i = 0; i < all_.rows(); ++i)
    if (isUnknown[at(i)])
      unknown_.push_back(i);
  const auto size = static_cast<Index>(unknown_.size());
  Matrix system(size, size);
  for (Index j = 0; j < size; ++j)
    for (Index i = 0; i < size; ++i)
      system(i, j) = all_(unknown_[at(i)], unknown_[at(j)]);
  factor_ = LuFactor(std::move(system));
}

// Kelvin's operators are Laplace's of each component for  μ = 1,  A = 1/2π,  B = 0.
void MixedLaplace::assemble(const Space& space) {
  Lame lame(Material{});
  lame.mu = 1;
  lame.a = 0.15915494309189535;
  lame.b = 0;
  const Operators kelvin = assemblePolynomialOperators(space, lame);
  const Index flows = space.densities() / 2;
  const Index potentials = space.displacements() / 2;
  for (Index j = 0; j < flows; ++j)
    for (Index i = j; i < flows; ++i)
      all_(i, j) = all_(j, i) = kelvin.singleLayer(2 * i, 2 * j);
  for (Index j = 0; j < potentials; ++j)
    for (Index i = 0; i < flows; ++i) {
      all_(flows + j, i) = kelvin.doubleLayer(2 * i, 2 * j);
      all_(i, flows + j) = -all_(flows + j, i);
    }
  const Mesh& mesh = space.mesh();
  for (int e = 0; e < mesh.size(); ++e) {
    const Matrix mass = massOf(mesh[e]);
    for (int i = 0; i < mesh[e].densities; ++i)
      for (int k = 0; k <= mesh[e].degree; ++k)
        all_(potentialOf(space, e, k), flowOf(space, e, i)) -= mass(i, k);
  }
  std::vector<std::vector<Entry>> slopes(at(potentials));  // dφ/ds by P
  for (int e = 0; e < mesh.size(); ++e)
    for (int k = 0; k <= mesh[e].degree; ++k)
      slopes[at(potentialOf(space, e, k) - flows)].push_back(
          {flowOf(space, e, std::max(k - 1, 0)), 0,
           DisplacementBasis::slope(k) / mesh[e].half});
  for (Index j = 0; j < potentials; ++j)
    for (Index i = 0; i < potentials; ++i)
      for (const Entry& a : slopes[at(i)])
        for (const Entry& b : slopes[at(j)])
          all_(flows + i, flows + j) += a.value * b.value * all_(a.row, b.row);
}

void MixedLaplace::holdConstants(const Space& space,
                                 const std::vector<bool>& isPotentialGiven) {
  const Mesh& mesh = space.mesh();
  std::vector<FreeLoop> loops(at(mesh.outline().loops()));
  std::vector<bool> isFree(loops.size(), true);
  for (int e = 0; e < mesh.size(); ++e) {
    const std::size_t k = at(mesh.outline().edge(mesh[e].piece.edge).loop);
    isFree[k] = isFree[k] && k > 0 && !isPotentialGiven[at(e)];
    loops[k].flows.push_back(flowOf(space, e, 0));
    loops[k].nodes.push_back(potentialOf(space, e, 0));
    loops[k].length += 2 * mesh[e].half;
  }
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (isFree[k]) {
      for (const Index i : loops[k].nodes)
        for (const Index j : loops[k].nodes)
          all_(i, j) += 1 / static_cast<double>(loops[k].nodes.size());
      freeLoops_.push_back(loops[k]);
    }
}

Vector MixedLaplace::solve(Vector data) const {
  for (const Index i : unknown_)
    data[at(i)] = 0;
  const Vector given = multiply(all_, data);
  Vector right;
  for (const Index i : unknown_)
    right.push_back(-given[at(i)]);
  factor_.solve(right);
  for (std::size_t k = 0; k < right.size(); ++k)
    data[at(unknown_[k])] = right[k];
  const Vector missed = freeLoops_.empty() ? Vector() : multiply(all_, data);
  for (const FreeLoop& loop : freeLoops_) {
    double sum = 0;
    for (const Index i : loop.flows)
      sum += missed[at(i)];
    for (const Index j : loop.nodes)
      data[at(j)] += sum / loop.length;
  }
  return data;
}

}  // namespace epafi::bem
