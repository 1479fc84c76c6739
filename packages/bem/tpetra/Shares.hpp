#pragma once

#include "bem/base/DenseAlgebra.hpp"

#include <algorithm>

namespace epafi::bem {

/// What a rank has of n indices dealt out in blocks of ceil(n/P); the last ranks may have
/// none.
inline Rows shareOf(int rank, int processes, Index n) {
  const Index height = (n + processes - 1) / processes;
  return {std::min(n, rank * height), std::min(n, (rank + 1) * height)};
}

}  // namespace epafi::bem
