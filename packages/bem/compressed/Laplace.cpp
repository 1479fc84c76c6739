#include "bem/compressed/Laplace.hpp"

#include "bem/operators/LocalFunctions.hpp"

#include <algorithm>
#include <cassert>

namespace epafi::bem {

MixedLaplace::MixedLaplace(const Space& space, const std::vector<bool>& isPotentialGiven,
                           const Compression& options)
    : space_(space) {
  assert(std::count(isPotentialGiven.begin(), isPotentialGiven.end(), true) > 0);
  if (space.mesh().outline().isAxisymmetric()) {
    rings_ = std::make_unique<const RingLaplace>(space, isPotentialGiven);
    return;
  }
  operators_ = std::make_unique<const CompressedOperators>(
      std::vector<CompressedOperators::Body>{{space, laplaceKernel()}}, options);
  findFreeLoops(isPotentialGiven);
  isUnknown_.assign(at(space.displacements() + space.densities()), false);
  std::fill_n(isUnknown_.begin(), space.displacements(), true);
  const Mesh& mesh = space.mesh();
  for (int e = 0; e < mesh.size(); ++e)
    if (isPotentialGiven[at(e)]) {
      for (int k = 0; k <= mesh[e].degree; ++k)
        isUnknown_[at(potentialOf(space, e, k))] = false;
      for (int i = 0; i < mesh[e].densities; ++i)
        isUnknown_[at(flowOf(space, e, i))] = true;
    }
  for (const FreeLoop& loop : freeLoops_)
    isUnknown_[at(loop.nodes.front())] = false;
  Restriction restriction;
  for (const bool isUnknown : isUnknown_)
    restriction.held.push_back(isUnknown ? 0 : 1);
  factor_ = std::make_unique<const CompressedFactor>(*operators_, std::move(restriction));
}

void MixedLaplace::findFreeLoops(const std::vector<bool>& isPotentialGiven) {
  const Mesh& mesh = space_.mesh();
  std::vector<FreeLoop> loops(at(mesh.outline().loops()));
  std::vector<bool> isFree(loops.size(), true);
  for (int e = 0; e < mesh.size(); ++e) {
    const std::size_t k = at(mesh.outline().edge(mesh[e].piece.edge).loop);
    isFree[k] = isFree[k] && k > 0 && !isPotentialGiven[at(e)];
    loops[k].flows.push_back(flowOf(space_, e, 0));
    loops[k].nodes.push_back(potentialOf(space_, e, 0));
    loops[k].length += 2 * mesh[e].half;
  }
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (isFree[k])
      freeLoops_.push_back(std::move(loops[k]));
}

Vector MixedLaplace::residual(const Vector& data) const {
  Matrix x(operators_->size(), 1);
  std::copy(data.begin(), data.end(), x.data());
  const Matrix image = operators_->times(x);
  Vector result;
  for (Index i = 0; i < image.rows(); ++i)
    result.push_back(-image(i, 0));
  const Mesh& mesh = space_.mesh();
  for (int e = 0; e < mesh.size(); ++e) {
    const Matrix mass = massOf(mesh[e]);
    for (int i = 0; i < mesh[e].densities; ++i)
      for (int k = 0; k <= mesh[e].degree; ++k)
        result[at(potentialOf(space_, e, k))] +=
            mass(i, k) * data[at(flowOf(space_, e, i))];
  }
  return result;
}

Vector MixedLaplace::solve(Vector data) const {
  if (rings_ != nullptr)
    return rings_->solve(std::move(data));
  for (const FreeLoop& loop : freeLoops_)
    data[at(loop.nodes.front())] = 0;
  for (std::size_t i = 0; i < data.size(); ++i)
    if (isUnknown_[i])
      data[i] = 0;
  const Vector missing = residual(data);
  Matrix right(operators_->size(), 1);
  for (std::size_t i = 0; i < data.size(); ++i)
    right(static_cast<Index>(i), 0) = isUnknown_[i] ? missing[i] : 0;
  const Matrix found = factor_->solve(right);
  for (std::size_t i = 0; i < data.size(); ++i)
    if (isUnknown_[i])
      data[i] = found(static_cast<Index>(i), 0);
  const Vector missed = freeLoops_.empty() ? Vector() : residual(data);
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
