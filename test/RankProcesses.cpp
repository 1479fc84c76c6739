#include "Processes.hpp"
#include "bem/tpetra/MpiProcesses.hpp"

#include <Tpetra_Core.hpp>

// Never destroyed: MPI ends before statics do.
const epafi::bem::Processes& epafi::test::processes() {
  static const auto* ranks = new bem::MpiProcesses(Tpetra::getDefaultComm());
  return *ranks;
}
