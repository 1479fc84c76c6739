#pragma once

#include "bem/base/DenseAlgebra.hpp"

namespace epafi::test {

/// What a suite computes with: LAPACK, or all ranks together where it starts under
/// mpirun.
const bem::DenseAlgebra& algebra();

}  // namespace epafi::test
