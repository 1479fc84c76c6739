#pragma once

#include "bem/operators/Kernel.hpp"
#include "bem/space/Space.hpp"

namespace epafi::bem {

/// Galerkin matrices of the boundary operators, with the signs of doc/theory/operators.md;
/// dimensionless.                                                              [P sec. 2]
struct Operators {
  Matrix singleLayer;    ///< V, densities x densities, lower triangle
  Matrix doubleLayer;    ///< K + 1/2, densities x displacements
  Matrix hypersingular;  ///< W, displacements x displacements, lower triangle
  /// Null unless the displacements represent rotations exactly.
  std::shared_ptr<const Rotation> rotation = nullptr;
};

/// Assembles V, K + 1/2 and W of a family of kernels from the double moments of all pairs of elements;
/// of plane elasticity:
///
///   V f = A (-log r) f + B (d d'/r²) f,
///   K v = K_Δ v - (2μ V - V_Δ) M v,  M v = (v₂', -v₁'),  V_Δ, K_Δ: Laplace's potentials,
///   <W u, v> = <V* u', v'>                              [doc/theory/operators.md]
///
/// The error of an entry is at most 1e-12 of the norm of the block of its pair of elements.
/// Displacements represent rotations exactly, see Rotation: K + 1/2 and W of a rigid motion are
/// rounding errors, on arcs, too.
/// Threads: over blocks of elements.
Operators assembleOperators(const Space& space, const Kernel& kernel);
inline Operators assembleOperators(const Space& space, const Lame& lame) {
  return assembleOperators(space, *elasticKernel(space.mesh().outline(), lame));
}

/// The same with displacements that are polynomials of arc length, without Rotation.
Operators assemblePolynomialOperators(const Space& space, const Kernel& kernel);

}  // namespace epafi::bem
