#pragma once

namespace epafi::bem {

/// When BelosSolver is content.
struct BelosOptions {
  double tolerance = 1e-13;      ///< residual relative to the right hand side, > 0
  int maximumIterations = 1000;  ///< > 0
  int blockSize = 64;            ///< right hand sides at once, > 0
};

}  // namespace epafi::bem
