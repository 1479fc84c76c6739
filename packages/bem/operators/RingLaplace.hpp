#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "bem/base/Material.hpp"
#include "bem/space/Space.hpp"

#include <vector>

namespace epafi::bem {

// Vector of the Cauchy data of a harmonic function on a Space of one component: T by nodes and
// bubbles, then its fluxes q = ∂T/∂n as Legendre series on the elements.
inline Index potentialOf(const Space& space, int e, int k) {
  return space.displacement(e, k, 0);
}
inline Index flowOf(const Space& space, int e, int i) {
  return space.displacements() + space.density(e, i, 0);
}

/// Of Lamé's operators of solids of revolution that have Laplace's in the components along the axis:
/// μ = 1/2, A = 1/4π, B = 0.
Lame lameOfRingLaplace();

/// MixedLaplace around an axis of revolution, with the kernel 1/(4π|w|) of points.  Dense: rings have no
/// point kernels that blocks far away could be made of.  On a surface beyond the first where only q is given
/// the constant of T follows from the mean of the first equation.
class RingLaplace {
 public:
  /// \param isPotentialGiven by element: is T given on it?
  /// \pre one component; T is given on an element
  RingLaplace(const Space& space, const std::vector<bool>& isPotentialGiven);

  /// Complete Cauchy data; entries of `data` that are not given are ignored.
  Vector solve(Vector data) const;

 private:
  /// A surface where only q is given: its constant fluxes, the nodes of the constant T.
  struct FreeSurface {
    std::vector<Index> flows;
    std::vector<Index> nodes;
    double area = 0;
  };
  void assemble(const Space& space);
  void holdConstants(const Space& space, const std::vector<bool>& isPotentialGiven);

  Matrix all_;  ///< [W, K' - 1/2; -(K + 1/2), V]
  std::vector<Index> unknown_;
  LuFactor factor_;
  std::vector<FreeSurface> freeSurfaces_;
};

}  // namespace epafi::bem
