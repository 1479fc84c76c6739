#pragma once

#include "Block.hpp"
#include "bem/tpetra/MpiProcesses.hpp"

namespace embed {

/// Strain energy of the pulled block, found by the application's own Belos solve with S.
struct Elastic {
  double energy;
  double exact;
  int iterations;
};

/// \throws std::runtime_error if Belos does not converge.
Elastic solveElastic(const Block& block, const epafi::bem::MpiProcesses& processes);

}  // namespace embed
