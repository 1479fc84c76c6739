#pragma once

#include "bem/operators/SteklovPoincare.hpp"

#include <memory>
#include <vector>

namespace epafi::bem {

/// The projected form costs dense algebra only where the assembly was asked for the kernels on
/// just these elements; else, and for the exact form, see KernelRows.
std::shared_ptr<const TractionRows> tractionRows(const Space& space, const Lame& lame,
                                                 const SteklovPoincare& stiffness,
                                                 const std::vector<int>& elements,
                                                 TractionForm form);

}  // namespace epafi::bem
