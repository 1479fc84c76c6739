#pragma once

#include "Block.hpp"
#include "bem/tpetra/MpiProcesses.hpp"

#include <vector>

namespace embed {

/// What LOCA found at one friction factor.
struct Point {
  double factor;
  double slipLength;
  double shear;       ///< sum of |λₜ| over the foundation, a force
  double difference;  ///< largest, to contact::solve from scratch, relative to the load
};

/// Follows the pressed block over the friction factor, 0.1 to 2.
/// \throws std::runtime_error if LOCA does not get there.
std::vector<Point> followFriction(const Block& block,
                                  const epafi::bem::MpiProcesses& processes);

}  // namespace embed
