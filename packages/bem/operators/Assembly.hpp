#pragma once

#include "bem/base/Material.hpp"
#include "bem/space/Space.hpp"
#include "bem/tractions/ProjectedTractions.hpp"

namespace epafi::bem {

/// The boundary operators as Galerkin matrices, [P sec. 2], with the signs of
/// doc/theory/operators.md; dimensionless.
struct Operators {
  Matrix singleLayer;         ///< V, densities x densities, lower triangle
  Matrix doubleLayer;         ///< K + 1/2, densities x displacements
  Matrix hypersingular;       ///< W, displacements x displacements, lower triangle
  TractionKernels tractions;  ///< on the elements asked for
  /// Null unless displacements hold a rotation beside polynomials, see withExactRotation.
  std::shared_ptr<const Rotation> rotation = nullptr;
};

/// Assembles V, K + 1/2 and W from one set of double moments per pair of elements:
///
///   V f = A (-log r) f + B (d d'/r²) f,
///   K v = K_Δ v - (2μ V - V_Δ) M v,  M v = (v₂', -v₁'),  V_Δ, K_Δ: Laplace's potentials,
///   <W u, v> = <V* u', v'>                              [doc/theory/operators.md]
///
/// Every entry is accurate to 1e-12 of the norm of its element pair's block.
/// Threads: over blocks of elements.
///
/// Where `tractionElements` are given, the kernels of their projected tractions come with them.
Operators assembleOperators(const Space& space, const Lame& lame,
                            const std::vector<int>& tractionElements = {});

}  // namespace epafi::bem
