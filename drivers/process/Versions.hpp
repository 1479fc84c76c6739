#pragma once

#include <string>

namespace epafi::drivers {

/// What computed a result.
struct Versions {
  std::string epafi;
  std::string trilinos;
  std::string mpi;
  std::string blasCore;  ///< the kernels that OpenBLAS chose, "unknown" for another BLAS
};

Versions versions();

}  // namespace epafi::drivers
