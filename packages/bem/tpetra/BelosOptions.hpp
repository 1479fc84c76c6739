#pragma once

#include "bem/base/Keys.hpp"

namespace epafi::bem {

/// Options of BelosSolver.
struct BelosOptions {
  double tolerance = 1e-13;      ///< residual relative to the right-hand side, > 0
  int maximumIterations = 1000;  ///< > 0
  int blockSize = 64;            ///< right-hand sides solved together, > 0

  void keys(Keys& keys) {
    keys.add(&tolerance, "Tolerance", "1", {0, 1, true, true},
             "Belos: residual relative to the right hand side");
    keys.add(&maximumIterations, "Maximum Iterations", "1", from(1),
             "Belos: steps for one column; beyond, the run ends with code 2");
    keys.add(&blockSize, "Block Size", "1", from(1), "Belos: columns at once");
  }
};

}  // namespace epafi::bem
