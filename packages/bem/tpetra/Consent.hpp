#pragma once

#include <functional>
#include <mpi.h>
#include <string>

namespace epafi::bem {

/// Failure of a rank.
struct Failure {
  int code = 0;  ///< exit code, > 0
  std::string message;
};

/// Thrown by confirm() on all ranks except the failing one.  Neither a NumericalError nor an
/// InputError, since handlers of those would then run on some ranks only.
struct FailedElsewhere : std::exception {
  explicit FailedElsewhere(Failure f) : failure(std::move(f)) {}
  const char* what() const noexcept override { return failure.message.c_str(); }
  Failure failure;
};

/// Prevents that ranks wait forever for one that has failed.
///
/// Every collective call begins with confirm().  A rank that throws calls report() where
/// the exception is caught.  Both are the same collective operation, so the report matches
/// the next confirm() of the other ranks, and all ranks know of the failure before they
/// exchange data:
///
///   failing rank:  ... throw ----------------> report()
///   the others:    ... multiply(): confirm() -> FailedElsewhere
///
/// For failures between the messages of a call, and for ranks that compute for long, report()
/// waits a bounded time; then it calls `lastResort`, which prints the failure, and MPI_Abort
/// with the code.
class Consent {
 public:
  using LastResort = std::function<void(const Failure&)>;

  /// Collective: duplicates the communicator.
  explicit Consent(MPI_Comm comm, LastResort lastResort = nullptr);
  ~Consent();
  Consent(const Consent&) = delete;
  Consent& operator=(const Consent&) = delete;

  /// Confirms that this rank has not failed.
  /// \throws FailedElsewhere if another rank has failed
  void confirm() const;

  /// Reports the failure of this rank.  Returns, on all ranks, the failure of the lowest
  /// failing rank.
  Failure report(const Failure& mine) const;

 private:
  Failure announce(int failingRank, const Failure& mine) const;

  MPI_Comm comm_ = MPI_COMM_NULL;
  int rank_ = 0;
  int processes_ = 1;
  LastResort lastResort_;
};

}  // namespace epafi::bem
