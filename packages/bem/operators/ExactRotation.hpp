#pragma once

#include "bem/operators/Assembly.hpp"

namespace epafi::bem {

/// Operators for displacements that represent rotations exactly, see Rotation:
/// Pᵀ W P and (K + 1/2) P; the traction kernels get W r_I and (K + 1/2) r_I as last columns.
/// Operators of a boundary without arcs are returned unchanged.
Operators withExactRotation(Operators operators, const Space& space);

/// Pᵀ C
Matrix withoutRotation(Matrix columns, const Rotation& rotation);

}  // namespace epafi::bem
