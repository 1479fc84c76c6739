#pragma once

#include "bem/operators/Kernel.hpp"
#include "bem/space/CauchyData.hpp"

namespace epafi::bem {

/// Energy norm (<W u, u> + <V ψ, ψ>)^½ of Cauchy data, dimensionless.
///
/// With W u = -d/ds V* du/ds [doc/theory/operators.md] both forms are double integrals of
/// Legendre series.  They are summed over pairs of elements, as accurately as in
/// assembleOperators, without a matrix.  A rigid translation has norm zero.
/// Threads: over elements; the sum does not depend on their number.
double energyNorm(const CauchyData& data, const Kernel& kernel);
inline double energyNorm(const CauchyData& data, const Lame& lame) {
  return energyNorm(data, *elasticKernel(data.mesh.outline(), lame));
}

}  // namespace epafi::bem
