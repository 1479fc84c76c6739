#pragma once

#include "bem/base/Material.hpp"
#include "bem/space/CauchyData.hpp"

namespace epafi::bem {

/// Energy norm (<W u, u> + <V ψ, ψ>)^½ of Cauchy data, dimensionless.
///
/// With W u = -d/ds V* du/ds [doc/theory/operators.md] both forms are double integrals of
/// Legendre series.  They are summed over pairs of elements, as accurately as in
/// assembleOperators, without a matrix.  A rigid translation has norm zero.
/// Threads: over elements; the sum does not depend on their number.
double energyNorm(const CauchyData& data, const Lame& lame);

}  // namespace epafi::bem
