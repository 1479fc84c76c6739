#include "Algebra.hpp"
#include "bem/tpetra/TpetraAlgebra.hpp"

#include <Tpetra_Core.hpp>

// Never destroyed: MPI ends before statics do.
const epafi::bem::DenseAlgebra& epafi::test::algebra() {
  static const auto* ranks = new bem::TpetraAlgebra(Tpetra::getDefaultComm());
  return *ranks;
}
