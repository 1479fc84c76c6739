#include "drivers/process/Versions.hpp"

#include "drivers/process/Threads.hpp"

#include <Trilinos_version.h>
#include <mpi.h>

namespace epafi::drivers {

namespace {

/// The version text of the library up to a comma or line end; allowed before MPI_Init.
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
