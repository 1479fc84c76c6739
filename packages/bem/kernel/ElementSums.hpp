#pragma once

#include "bem/kernel/Elasticity.hpp"
#include "bem/moments/LegendreMoments.hpp"

namespace epafi::bem {

/// The sums of P_j on the straight element with unit tangent `tangent`, in closed form
/// from its moments (c and d) at a target.                 [doc/theory/operators.md]
SourceSums elementSums(Complex tangent, const RelativeTarget& target,
                       const LegendreMoments& moments, int j);

}  // namespace epafi::bem
