#include "bem/operators/Laplace.hpp"

#include "bem/algebra/DenseAlgebra.hpp"
#include "bem/mesh/Surfaces.hpp"
#include "bem/operators/Assembly.hpp"
#include "bem/operators/LocalFunctions.hpp"
#include "bem/operators/RingBlocks.hpp"

#include <algorithm>
#include <cassert>

namespace epafi::bem {

MixedLaplace::MixedLaplace(const Space& space, const std::vector<bool>& isPotentialGiven)
    : all_((space.densities() + space.displacements()) / 2,
           (space.densities() + space.displacements()) / 2) {
  assert(std::count(isPotentialGiven.begin(), isPotentialGiven.end(), true) > 0);
  assert(std::all_of(
      space.mesh().elements().begin(), space.mesh().elements().end(),
      [](const Element& e) { return e.densities == 0 || e.densities == e.degree; }));
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

Lame lameOfLaplace(bool isAxisymmetric) {
  Lame lame(Material{});
  lame.nu = 0;
  lame.mu = isAxisymmetric ? 0.5 : 1;  // of rings that of W's curls, too
  lame.a = 0.15915494309189535;
  lame.b = 0;
  return lame;
}

void MixedLaplace::assemble(const Space& space) {
  const Mesh& mesh = space.mesh();
  const bool isAxisymmetric = mesh.outline().isAxisymmetric();
  const Operators kelvin =
      assemblePolynomialOperators(space, lameOfLaplace(isAxisymmetric));
  const int c = isAxisymmetric ? 1 : 0;
  const Index flows = space.densities() / 2;
  const Index potentials = space.displacements() / 2;
  for (Index j = 0; j < flows; ++j)
    for (Index i = j; i < flows; ++i)
      all_(i, j) = all_(j, i) = kelvin.singleLayer(2 * i + c, 2 * j + c);
  for (Index j = 0; j < potentials; ++j)
    for (Index i = 0; i < flows; ++i) {
      all_(flows + j, i) = kelvin.doubleLayer(2 * i + c, 2 * j + c);
      all_(i, flows + j) = -all_(flows + j, i);
    }
  for (int e = 0; e < mesh.size(); ++e) {
    const Matrix mass = isAxisymmetric ? ringMassOf(mesh, e) : massOf(mesh[e]);
    for (int i = 0; i < mesh[e].densities; ++i)
      for (int k = 0; k <= mesh[e].degree; ++k)
        all_(potentialOf(space, e, k), flowOf(space, e, i)) -= mass(i, k);
  }
  if (isAxisymmetric) {
    for (Index j = 0; j < potentials; ++j)
      for (Index i = j; i < potentials; ++i)
        all_(flows + i, flows + j) = all_(flows + j, flows + i) =
            kelvin.hypersingular(2 * i + c, 2 * j + c);
    return;
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
  const std::vector<Surface> surfaces = surfacesOf(space.mesh());
  for (std::size_t k = 1; k < surfaces.size(); ++k) {
    const std::vector<int>& elements = surfaces[k].elements;
    if (std::any_of(elements.begin(), elements.end(),
                    [&](int e) { return isPotentialGiven[at(e)]; }))
      continue;
    FreeLoop loop;
    loop.size = surfaces[k].size;
    for (const int e : elements) {
      loop.flows.push_back(flowOf(space, e, 0));
      loop.nodes.push_back(potentialOf(space, e, 0));
    }
    if (!surfaces[k].isClosed)
      loop.nodes.push_back(potentialOf(space, elements.back(), 1));
    for (const Index i : loop.nodes)
      for (const Index j : loop.nodes)
        all_(i, j) += 1 / static_cast<double>(loop.nodes.size());
    freeLoops_.push_back(std::move(loop));
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
      data[at(j)] += sum / loop.size;
  }
  return data;
}

}  // namespace epafi::bem
