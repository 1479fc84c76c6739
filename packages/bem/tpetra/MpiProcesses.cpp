#include "bem/tpetra/MpiProcesses.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

namespace epafi::bem {

namespace {

using Teuchos::RCP;
using Teuchos::rcp;

/// The communicator inside, or that of this process alone for a serial one.
MPI_Comm mpiOf(const Teuchos::Comm<int>& comm) {
  const auto* mpi = dynamic_cast<const Teuchos::MpiComm<int>*>(&comm);
  if (mpi == nullptr)
    return MPI_COMM_SELF;
  return *mpi->getRawMpiComm();
}

}  // namespace

MpiProcesses::MpiProcesses(RCP<const Teuchos::Comm<int>> comm,
                           Consent::LastResort lastResort)
    : comm_(std::move(comm)),
      mpi_(mpiOf(*comm_)),
      consent_(std::make_unique<Consent>(mpi_, std::move(lastResort))) {}

RCP<const Tpetra::Map<>> MpiProcesses::rowMap(Index n) const {
  return rcp(new Tpetra::Map<>(n, 0, comm_));
}

RCP<const Tpetra::Map<>> MpiProcesses::replicatedMap(Index n) const {
  return rcp(new Tpetra::Map<>(n, 0, comm_, Tpetra::LocallyReplicated));
}

// Reduced on one process and sent out, so that all have the same bits.
Vector MpiProcesses::sum(Vector mine) const {
  if (count() == 1)
    return mine;
  Vector total(mine.size());
  consent_->confirm();
  const int n = asInt(static_cast<Index>(mine.size()));
  MPI_Reduce(mine.data(), total.data(), n, MPI_DOUBLE, MPI_SUM, 0, mpi_);
  MPI_Bcast(total.data(), n, MPI_DOUBLE, 0, mpi_);
  return total;
}

Vector MpiProcesses::broadcast(Vector root) const {
  if (count() == 1)
    return root;
  consent_->confirm();
  auto size = static_cast<long>(root.size());
  MPI_Bcast(&size, 1, MPI_LONG, 0, mpi_);
  root.resize(static_cast<std::size_t>(size));
  MPI_Bcast(root.data(), static_cast<int>(size), MPI_DOUBLE, 0, mpi_);
  return root;
}

}  // namespace epafi::bem
