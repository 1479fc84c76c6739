#pragma once

#include "bem/base/Processes.hpp"
#include "bem/tpetra/Consent.hpp"

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <Tpetra_Map.hpp>

#include <memory>

namespace epafi::bem {

/// The processes of a communicator.
///
/// Every collective call begins with Consent::confirm(), so that the failure of one process ends
/// all of them.
class MpiProcesses final : public Processes {
 public:
  /// Collective.
  explicit MpiProcesses(Teuchos::RCP<const Teuchos::Comm<int>> comm,
                        Consent::LastResort lastResort = nullptr);

  Vector sum(Vector mine) const override;
  Vector broadcast(Vector root) const override;
  int rank() const override { return comm_->getRank(); }
  int count() const override { return comm_->getSize(); }

  const Consent& consent() const { return *consent_; }

  /// Map of n distributed rows; map of n replicated entries.
  Teuchos::RCP<const Tpetra::Map<>> rowMap(Index n) const;
  Teuchos::RCP<const Tpetra::Map<>> replicatedMap(Index n) const;

 private:
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
  MPI_Comm mpi_ = MPI_COMM_SELF;
  std::unique_ptr<Consent> consent_;
};

}  // namespace epafi::bem
