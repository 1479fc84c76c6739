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

/// The processes of a run: those that mpirun has started, else this one, which then
/// leaves MPI alone.
class Ranks {
 public:
  /// Starts MPI under mpirun.
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  const bem::Processes& processes() const;

  /// Starts MPI, if that is still to be done: Belos does not work without.
  std::unique_ptr<const bem::SingleLayerSolver> belosSolver(
      const bem::BelosOptions& options) const;

  /// One rank writes files and speaks.
  bool isFirst() const { return processes().rank() == 0; }
  bool underMpirun() const { return underMpirun_; }
  /// catchSignals as is right for this rank.
  void listenToSignals() const;

  /// Does work() and returns nothing, or what kept one of the ranks from doing it: the
  /// same on all of them.
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
  // made when they are needed; scope_ ends MPI, last of all
  mutable std::unique_ptr<Tpetra::ScopeGuard> scope_;
  mutable std::unique_ptr<const bem::MpiProcesses> tpetra_;
};

/// Prints the one message of a run that fails.
void tell(const bem::Failure& failure);

/// The largest over all ranks, number by number.
bem::Vector largestOverRanks(const bem::Processes& processes, const bem::Vector& mine);

}  // namespace epafi::drivers
