#include "drivers/process/Versions.hpp"

#include <Trilinos_version.h>
#include <dlfcn.h>
#include <mpi.h>

namespace epafi::drivers {

namespace {

/// Asked at run time: another BLAS does not have the function.
std::string blasCore() {
  using Name = char* (*)();
  const auto name = reinterpret_cast<Name>(dlsym(RTLD_DEFAULT, "openblas_get_corename"));
  return name == nullptr ? "unknown" : name();
}

/// The first line of what the library says of itself; allowed before MPI_Init.
std::string mpiVersion() {
  char text[MPI_MAX_LIBRARY_VERSION_STRING] = "";
  int length = 0;
  MPI_Get_library_version(text, &length);
  const std::string version(text);
  return version.substr(0, version.find_first_of(",\n"));
}

}  // namespace

Versions versions() {
  return {EPAFI_VERSION, TRILINOS_VERSION_STRING, mpiVersion(), blasCore()};
}

}  // namespace epafi::drivers
