#pragma once

#include "bem/kernel/Elasticity.hpp"
#include "bem/moments/LegendreMoments.hpp"

namespace epafi::bem {

/// The sums of P_j on a segment in closed form from its moments (c and d) at a target.
///                                                         [doc/theory/operators.md]
SourceSums elementSums(const Curve& segment, const RelativeTarget& target,
                       const LegendreMoments& moments, int j);

}  // namespace epafi::bem
