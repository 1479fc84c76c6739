#pragma once

#include <functional>
#include <mpi.h>
#include <string>

namespace epafi::bem {

/// Why a rank cannot go on.
struct Failure {
  int code = 0;  ///< the exit code it stands for, > 0
  std::string message;
};

/// Thrown on all ranks but the failing one, where they next ask for consent.  Neither a
/// NumericalError nor an InputError: whoever handles those would do so on some ranks
/// only.
struct FailedElsewhere : std::exception {
  explicit FailedElsewhere(Failure f) : failure(std::move(f)) {}
  const char* what() const noexcept override { return failure.message.c_str(); }
  Failure failure;
};

/// Keeps ranks from waiting for one that has failed.
///
/// Every collective call begins with confirm(): "I am well".  A rank that fails unwinds
/// to a place that catches everything and calls report() there.  The two are one
/// collective operation, so a report meets the others' next confirm(), whatever they were
/// about to do, and all ranks know of it before any of them can wait for the lost one:
///
///   failing rank:  ... throw ----------------> report()
///   the others:    ... multiply(): confirm() -> FailedElsewhere
///
/// What remains are failures between the messages of one call and ranks that are busy for
/// long: report() waits for the others a bounded time, then `lastResort` says why, and
/// MPI_Abort ends all ranks with the code.
class Consent {
 public:
  using LastResort = std::function<void(const Failure&)>;

  /// Collective: takes a communicator of its own.
  explicit Consent(MPI_Comm comm, LastResort lastResort = nullptr);
  ~Consent();
  Consent(const Consent&) = delete;
  Consent& operator=(const Consent&) = delete;

  /// This rank is well.
  /// \throws FailedElsewhere if another one is not.
  void confirm() const;

  /// This rank has failed.  Returns what all ranks agree upon: the failure of the lowest
  /// of those that have one.
  Failure report(const Failure& mine) const;

 private:
  Failure announce(int failingRank, const Failure& mine) const;

  MPI_Comm comm_ = MPI_COMM_NULL;
  int rank_ = 0;
  int processes_ = 1;
  LastResort lastResort_;
};

}  // namespace epafi::bem
