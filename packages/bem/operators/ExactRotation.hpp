#pragma once

#include "bem/operators/Assembly.hpp"

namespace epafi::bem {

/// The operators of displacements that hold the rotation exactly, see Rotation:
/// Pᵀ W P and (K + 1/2) P; W r_I and (K + 1/2) r_I as the last columns of the tractions'
/// kernels.  Those of a straight boundary are left as they are.
Operators withExactRotation(Operators operators, const Space& space);

/// Pᵀ C
Matrix withoutRotation(Matrix columns, const Rotation& rotation);

}  // namespace epafi::bem
