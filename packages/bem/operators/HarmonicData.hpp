#pragma once

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

/// By entry: is it to be found, if T is given on these elements and q on the others?
std::vector<bool> missingData(const Space& space,
                              const std::vector<bool>& isPotentialGiven);

/// The surface of a hole where only q is given, on which the equation of q leaves a constant of T free.
struct FreeSurface {
  std::vector<Index> flows;  ///< constant ones
  std::vector<Index> nodes;  ///< of the constant T
  double size = 0;           ///< length, or area of the whole revolution

  /// Adds the constant to T.  \param missed  V q - (1/2 + K) T, tested by flows
  void addConstant(const Vector& missed, Vector& data) const;
};

std::vector<FreeSurface> freeSurfaces(const Space& space,
                                      const std::vector<bool>& isPotentialGiven);

}  // namespace epafi::bem
