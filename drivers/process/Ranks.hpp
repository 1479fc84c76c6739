#pragma once

#include "bem/base/Processes.hpp"
#include "bem/operators/SingleLayerSolver.hpp"
#include "bem/tpetra/BelosOptions.hpp"
#include "bem/tpetra/Consent.hpp"

#include <memory>
#include <optional>

namespace Tpetra {
class ScopeGuard;
}

namespace epafi::bem {
class MpiProcesses;
}

namespace epafi::drivers {

/// The processes of a run: all ranks under mpirun, otherwise this process alone, which
/// does not start MPI unless it is needed.
class Ranks {
 public:
  /// Starts MPI under mpirun.
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  const bem::Processes& processes() const;

  /// Starts MPI if necessary: Belos needs it.
  std::unique_ptr<const bem::SingleLayerSolver> belosSolver(
      const bem::BelosOptions& options) const;

  /// Only the first rank writes files and prints.
  bool isFirst() const { return processes().rank() == 0; }
  bool underMpirun() const { return underMpirun_; }
  /// Calls catchSignals with the grace and voice of this rank.
  void listenToSignals() const;

  /// Calls work().  Returns nothing, or, on all ranks, the same failure of one of them.
  /// Collective.
  template <class Work>
  std::optional<bem::Failure> attempt(const Work& work) const {
    try {
      work();
      confirm();
      return std::nullopt;
    } catch (const bem::FailedElsewhere& elsewhere) {
      return elsewhere.failure;
    } catch (...) {
      return agree(currentFailure());
    }
  }

 private:
  static bem::Failure currentFailure();
  void confirm() const;
  bem::Failure agree(const bem::Failure& mine) const;

  const bem::MpiProcesses& tpetra() const;

  bool underMpirun_;
  bem::OneProcess alone_;
  // created on demand; scope_ is destroyed last and ends MPI
  mutable std::unique_ptr<Tpetra::ScopeGuard> scope_;
  mutable std::unique_ptr<const bem::MpiProcesses> tpetra_;
};

/// Prints the error message of a run that fails.
void tell(const bem::Failure& failure);

/// Maximum over all ranks, entry by entry.  Collective.
bem::Vector largestOverRanks(const bem::Processes& processes, const bem::Vector& mine);

}  // namespace epafi::drivers
