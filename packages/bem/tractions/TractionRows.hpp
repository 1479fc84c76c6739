#pragma once

#include "bem/operators/SteklovPoincare.hpp"

#include <memory>
#include <vector>

namespace epafi::bem {

enum class TractionForm {
  Projected,  ///< only the columns up to degree p                         [P (42)]
  Exact       ///< all that matters to 1e-12 of the quadratic form         [P sec. 6]
};

/// The projected form costs dense algebra only where the assembly was asked for the
/// kernels on just these elements; else, and for the exact form, outer points are graded
/// to the ends of near elements, where S φ has logarithms; far sources take the orders of
/// FarOrder.  No difference quotients.
std::shared_ptr<const TractionRows> tractionRows(const Space& space, const Lame& lame,
                                                 const SteklovPoincare& stiffness,
                                                 const std::vector<int>& elements,
                                                 TractionForm form);

}  // namespace epafi::bem
