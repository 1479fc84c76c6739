#pragma once

#include "bem/operators/Assembly.hpp"

namespace epafi::bem {

/// Operators for displacements that represent rotations exactly, see Rotation:
/// Pᵀ W P and (K + 1/2) P.  Operators of a boundary without arcs are returned unchanged.
Operators withExactRotation(Operators operators, const Space& space);

/// Pᵀ C
Matrix withoutRotation(Matrix columns, const Rotation& rotation);

}  // namespace epafi::bem
