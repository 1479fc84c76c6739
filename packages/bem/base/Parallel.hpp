#pragma once

#include "bem/base/Matrix.hpp"

#include <atomic>
#include <functional>

namespace epafi::bem {

// Work is estimated in nanoseconds of one thread.  The order of magnitude suffices, since it is
// only used to choose the number of threads of a loop or of a call of BLAS.

/// Work of floating point operations of matrix products and factorizations.
constexpr double workOfFlops(double flops) { return 0.05 * flops; }
/// Work of reading or writing numbers, each once.
constexpr double workOfNumbers(double count) { return 0.5 * count; }
/// Work of A X for a rows x depth matrix A and a depth x columns matrix X.
constexpr double workOfProduct(Index rows, Index depth, Index columns) {
  const double entries = static_cast<double>(rows) * static_cast<double>(depth);
  return workOfNumbers(entries) + workOfFlops(2 * entries * static_cast<double>(columns));
}

/// Number of threads for this work [ns]: 100 microseconds for each, about ten times the cost of
/// waking it.  At least 1, at most the number of OpenMP threads; 1 inside a parallel loop.
int threadsFor(double work);

/// Number of threads for a call of BLAS: 20 milliseconds for each, since the threads of OpenBLAS
/// synchronize many times in a call and wait for each one that has lost its processor.
int blasThreadsFor(double work);

/// A loop over independent rounds 0, 1, ...
struct Job {
  Index rounds = 0;
  double work = 0;   ///< of all rounds together [ns]
  Index atOnce = 1;  ///< rounds that a thread takes at a time, in ascending order
};

/// Scheduler of a job: rounds that no thread has taken yet.
class Rounds {
 public:
  explicit Rounds(const Job& job) : job_(job) {}

  /// Takes the rounds first ... last - 1; false if none are left.
  bool take(Index& first, Index& last);
  /// Cancels all remaining rounds.
  void stop() { next_ = job_.rounds; }

 private:
  Job job_;
  std::atomic<Index> next_ = 0;
};

/// Calls worker(rounds) on threadsFor(job.work) threads including this one.  Does not wait for
/// threads that start when no rounds are left.  With several threads, OpenBLAS has one thread
/// meanwhile.
/// \throws the first exception of a worker; the other workers then take no more rounds
void onThreads(const Job& job, const std::function<void(Rounds&)>& worker);

/// Calls body(workspace, k) for all rounds k, with workspace = makeWorkspace() for each
/// thread.
/// \throws the first exception of makeWorkspace or body; rounds not yet begun are skipped
template <class MakeWorkspace, class Body>
void parallelFor(const Job& job, const MakeWorkspace& makeWorkspace, const Body& body) {
  onThreads(job, [&](Rounds& rounds) {
    auto workspace = makeWorkspace();
    for (Index first = 0, last = 0; rounds.take(first, last);)
      for (Index k = first; k < last; ++k)
        body(workspace, k);
  });
}

/// Calls body(k) for all rounds k.
template <class Body>
void parallelFor(const Job& job, const Body& body) {
  onThreads(job, [&](Rounds& rounds) {
    for (Index first = 0, last = 0; rounds.take(first, last);)
      for (Index k = first; k < last; ++k)
        body(k);
  });
}

}  // namespace epafi::bem
