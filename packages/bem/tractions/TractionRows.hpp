#pragma once

#include "bem/operators/SteklovPoincare.hpp"

#include <memory>
#include <vector>

namespace epafi::bem {

/// TractionRows on `elements`.  If they equal stiffness.tractionElements(), the projected form
/// costs no kernel evaluations; otherwise, and for the exact form, see KernelRows.
std::shared_ptr<const TractionRows> tractionRows(const Space& space, const Lame& lame,
                                                 const SteklovPoincare& stiffness,
                                                 const std::vector<int>& elements,
                                                 TractionForm form);

}  // namespace epafi::bem
