#pragma once

#include "bem/base/Material.hpp"
#include "bem/space/CauchyData.hpp"

namespace epafi::bem {

/// (<W u, u> + <V ψ, ψ>)^½, dimensionless: the norm in which the method converges.
///
/// W u = -d/ds V* du/ds [doc/theory/operators.md], so that both forms are double integrals of
/// Legendre series; they are summed pair by pair, with the accuracy of assembleOperators
/// but without a matrix.  A rigid translation has norm zero.
/// Threads: over elements; the sum does not depend on their number.
double energyNorm(const CauchyData& data, const Lame& lame);

}  // namespace epafi::bem
