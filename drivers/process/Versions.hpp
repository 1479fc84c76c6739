#pragma once

#include <string>

namespace epafi::drivers {

/// Versions of the program and the libraries that compute a result.
struct Versions {
  std::string epafi;
  std::string trilinos;
  std::string mpi;
  std::string blasCore;  ///< see blasCore()
};

Versions versions();

}  // namespace epafi::drivers
