#pragma once

#include "bem/base/Matrix.hpp"

#include <algorithm>

namespace epafi::bem {

/// Calls action(first, count) for blocks of columns, by OpenMP's threads where none of their
/// loops has begun.
template <class Action>
void byColumns(Index columns, const Action& action) {
  constexpr Index width = 128;
#pragma omp parallel for schedule(dynamic, 1) if (columns > width)
  for (Index first = 0; first < columns; first += width)
    action(first, std::min(width, columns - first));
}

}  // namespace epafi::bem
