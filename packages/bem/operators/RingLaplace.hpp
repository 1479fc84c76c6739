#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "bem/base/Material.hpp"
#include "bem/operators/HarmonicData.hpp"

#include <vector>

namespace epafi::bem {

/// Of Lamé's operators of solids of revolution that have Laplace's in the components along the axis:
/// μ = 1/2, A = 1/4π, B = 0.
Lame lameOfRingLaplace();

/// MixedLaplace around an axis of revolution, with the kernel 1/(4π|w|) of points.  Dense, as are the potentials
/// of RingPotential that its data go to.  On a surface beyond the first where only q is given
/// the constant of T follows from the mean of the first equation.
class RingLaplace {
 public:
  /// \param isPotentialGiven by element: is T given on it?
  /// \pre one component; T is given on an element
  RingLaplace(const Space& space, const std::vector<bool>& isPotentialGiven);

  /// Complete Cauchy data; entries of `data` that are not given are ignored.
  Vector solve(Vector data) const;

 private:
  void assemble(const Space& space);
  void holdConstants();

  std::vector<FreeSurface> freeSurfaces_;
  Matrix all_;  ///< [W, K' - 1/2; -(K + 1/2), V]
  std::vector<Index> unknown_;
  LuFactor factor_;
};

}  // namespace epafi::bem
