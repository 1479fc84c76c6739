#include "bem/operators/RingLaplace.hpp"

#include "bem/algebra/Products.hpp"
#include "bem/operators/Assembly.hpp"
#include "bem/operators/Kernel.hpp"
#include "bem/operators/RingBlocks.hpp"

#include <algorithm>
#include <cassert>

namespace epafi::bem {

Lame lameOfRingLaplace() {
  Lame lame(Material{});
  lame.nu = 0;
  lame.mu = 0.5;  // of W's curls, too
  lame.a = 0.15915494309189535;
  lame.b = 0;
  return lame;
}

RingLaplace::RingLaplace(const Space& space, const std::vector<bool>& isPotentialGiven)
    : freeSurfaces_(freeSurfaces(space, isPotentialGiven)),
      all_(space.displacements() + space.densities(),
           space.displacements() + space.densities()) {
  assert(std::count(isPotentialGiven.begin(), isPotentialGiven.end(), true) > 0);
  assemble(space);
  holdConstants();
  const std::vector<bool> isMissing = missingData(space, isPotentialGiven);
  for (Index i = 0; i < all_.rows(); ++i)
    if (isMissing[at(i)])
      unknown_.push_back(i);
  const auto size = static_cast<Index>(unknown_.size());
  Matrix system(size, size);
  for (Index j = 0; j < size; ++j)
    for (Index i = 0; i < size; ++i)
      system(i, j) = all_(unknown_[at(i)], unknown_[at(j)]);
  factor_ = LuFactor(std::move(system));
}

void RingLaplace::assemble(const Space& space) {
  constexpr int c = 1;  // along the axis
  const Mesh& mesh = space.mesh();
  const Operators lame = assemblePolynomialOperators(
      Space(mesh), *elasticKernel(mesh.outline(), lameOfRingLaplace()));
  const Index potentials = space.displacements();
  const Index flows = space.densities();
  for (Index j = 0; j < flows; ++j)
    for (Index i = j; i < flows; ++i)
      all_(potentials + i, potentials + j) = all_(potentials + j, potentials + i) =
          lame.singleLayer(2 * i + c, 2 * j + c);
  for (Index j = 0; j < potentials; ++j)
    for (Index i = 0; i < flows; ++i) {
      all_(j, potentials + i) = lame.doubleLayer(2 * i + c, 2 * j + c);
      all_(potentials + i, j) = -all_(j, potentials + i);
    }
  for (int e = 0; e < mesh.size(); ++e) {
    const Matrix mass = ringMassOf(mesh, e);
    for (int i = 0; i < mesh[e].densities; ++i)
      for (int k = 0; k <= mesh[e].degree; ++k)
        all_(potentialOf(space, e, k), flowOf(space, e, i)) -= mass(i, k);
  }
  for (Index j = 0; j < potentials; ++j)
    for (Index i = j; i < potentials; ++i)
      all_(i, j) = all_(j, i) = lame.hypersingular(2 * i + c, 2 * j + c);
}

void RingLaplace::holdConstants() {
  for (const FreeSurface& surface : freeSurfaces_)
    for (const Index i : surface.nodes)
      for (const Index j : surface.nodes)
        all_(i, j) += 1 / static_cast<double>(surface.nodes.size());
}

Vector RingLaplace::solve(Vector data) const {
  for (const Index i : unknown_)
    data[at(i)] = 0;
  const Vector given = product(all_, data);
  Vector right;
  for (const Index i : unknown_)
    right.push_back(-given[at(i)]);
  factor_.solve(right);
  for (std::size_t k = 0; k < right.size(); ++k)
    data[at(unknown_[k])] = right[k];
  const Vector missed = freeSurfaces_.empty() ? Vector() : product(all_, data);
  for (const FreeSurface& surface : freeSurfaces_)
    surface.addConstant(missed, data);
  return data;
}

}  // namespace epafi::bem
