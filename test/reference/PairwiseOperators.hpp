#pragma once

#include "bem/operators/Assembly.hpp"

namespace epafi::reference {

/// V, K + 1/2 and W pair by pair, every entry by Scatter: the slow twin of the assembly
/// by tiles.  Without tractions, by one thread.
bem::Operators pairwiseOperators(const bem::Space& space, const bem::Lame& lame);

}  // namespace epafi::reference
