#pragma once

#include "bem/algebra/LuFactor.hpp"
#include "bem/base/Material.hpp"
#include "bem/space/Space.hpp"

#include <vector>

namespace epafi::bem {

// Vector of the Cauchy data of a harmonic function: its fluxes q = ∂T/∂n as Legendre series on the
// elements, then T by nodes and bubbles; both numbered as one component of a Space.
inline Index flowOf(const Space& space, int e, int i) {
  return space.density(e, i, 0) / 2;
}
inline Index potentialOf(const Space& space, int e, int k) {
  return (space.densities() + space.displacement(e, k, 0)) / 2;
}

/// Kelvin's operators are Laplace's of each component for  μ = 1,  A = 1/2π,  B = 0;  those of
/// solids of revolution have Laplace's in the components along the axis for  μ = 1/2,  A = 1/4π.
Lame lameOfLaplace(bool isAxisymmetric);

/// Interior mixed problem of Laplace: T given on some elements, q on the others.  With w = x - y
///
///   V q = -1/2π ∫ log|w| q ds,  K T = 1/2π ∫ (w·n_y)/|w|² T ds,  W T = -d/ds V (dT/ds),
///   V q = (1/2 + K) T,          W T = (1/2 - K') q,
///
/// the first equation is tested where T is given, the second where q is; around an axis of revolution
/// with 1/4π|w| of points.  On a hole where only q is given, the second leaves a constant of T free;
/// the mean of the first over the hole fixes it.
/// Dense.  Dimensionless, diameter of the outline at most 1.      [doc/theory/operators.md]
class MixedLaplace {
 public:
  /// \param isPotentialGiven by element: is T given on it?
  /// \pre T is given on an element; each element off the axis has as many densities as its degree
  MixedLaplace(const Space& space, const std::vector<bool>& isPotentialGiven);

  /// Complete Cauchy data; entries of `data` that are not given are ignored.
  Vector solve(Vector data) const;

  /// [V, -(K + 1/2); K' - 1/2, W], with a term in W for the constants on such holes.
  const Matrix& operators() const { return all_; }

 private:
  /// A hole where only q is given: its constant fluxes, the nodes of the constant T.
  struct FreeLoop {
    std::vector<Index> flows;
    std::vector<Index> nodes;
    double size = 0;  ///< length or area
  };
  void assemble(const Space& space);
  void holdConstants(const Space& space, const std::vector<bool>& isPotentialGiven);

  Matrix all_;
  std::vector<Index> unknown_;
  LuFactor factor_;
  std::vector<FreeLoop> freeLoops_;
};

}  // namespace epafi::bem
