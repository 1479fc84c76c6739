#pragma once

#include "bem/operators/Assembly.hpp"

namespace epafi::bem {

/// The operators of displacements that hold the rotation exactly, see Rotation:
/// Pᵀ W P and (K + 1/2) P; W r_I and (K + 1/2) r_I as the last columns of the tractions'
/// kernels.  Those of a straight boundary are left as they are.
/// Collective.
Operators withExactRotation(Operators operators, const Space& space,
                            const DenseAlgebra& algebra);

/// Pᵀ C of columns by my rows of the displacements.  Collective.
Matrix withoutRotation(Matrix columns, const Rotation& rotation,
                       const DenseAlgebra& algebra);

}  // namespace epafi::bem
