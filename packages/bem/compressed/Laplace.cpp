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
  freeSurfaces_ = freeSurfaces(space, isPotentialGiven);
  isUnknown_ = missingData(space, isPotentialGiven);
  for (const FreeSurface& hole : freeSurfaces_)
    isUnknown_[at(hole.nodes.front())] = false;
  Restriction restriction;
  for (const bool isUnknown : isUnknown_)
    restriction.held.push_back(isUnknown ? 0 : 1);
  factor_ = std::make_unique<const CompressedFactor>(*operators_, std::move(restriction));
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
  for (const FreeSurface& hole : freeSurfaces_)
    data[at(hole.nodes.front())] = 0;
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
  const Vector missed = freeSurfaces_.empty() ? Vector() : residual(data);
  for (const FreeSurface& hole : freeSurfaces_)
    hole.addConstant(missed, data);
  return data;
}

}  // namespace epafi::bem
