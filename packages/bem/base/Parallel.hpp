#pragma once

#include "bem/base/Matrix.hpp"

#include <atomic>
#include <functional>

namespace epafi::bem {

// Work is estimated in nanoseconds of one thread.  Its order of magnitude is enough: it
// decides how many threads a loop or a call of BLAS gets, here and nowhere else.

/// Of products and factorisations of matrices.
constexpr double workOfFlops(double flops) { return 0.05 * flops; }
/// Of reading or writing numbers, each once.
constexpr double workOfNumbers(double count) { return 0.5 * count; }
/// Of A X, `columns` those of X.
constexpr double workOfProduct(Index rows, Index depth, Index columns) {
  const double entries = static_cast<double>(rows) * static_cast<double>(depth);
  return workOfNumbers(entries) + workOfFlops(2 * entries * static_cast<double>(columns));
}

/// Threads that some work [ns] pays for: those that have 100 microseconds each, of which waking
/// them takes a tenth.  At least 1, at most as many as OpenMP would have; 1 in the rounds of a
/// loop that has several.
int threadsFor(double work);

/// The same for a call of BLAS: OpenBLAS' threads meet dozens of times in it, and each time all
/// wait for one that has lost its processor, so that it takes 20 milliseconds each.
int blasThreadsFor(double work);

/// Rounds 0, 1, ... of a loop that may run at the same time.
struct Job {
  Index rounds = 0;
  double work = 0;   ///< of all rounds together [ns]
  Index atOnce = 1;  ///< rounds that a thread takes at once, the first ones first
};

/// The rounds of a job that no thread has taken yet.
class Rounds {
 public:
  explicit Rounds(const Job& job) : job_(job) {}

  /// Takes first ... last - 1; false: none are left.
  bool take(Index& first, Index& last);
  /// Leaves the rest.
  void stop() { next_ = job_.rounds; }

 private:
  Job job_;
  std::atomic<Index> next_ = 0;
};

/// Calls worker(rounds) on as many threads as the work pays for, here among them: others that
/// come when no rounds are left are not waited for.  OpenBLAS has one thread meanwhile if they
/// are several.
/// \throws the first exception that a worker throws; the others then take no more rounds.
void onThreads(const Job& job, const std::function<void(Rounds&)>& worker);

/// Calls body(workspace, k) for all rounds k, with a workspace = makeWorkspace() of each
/// thread's own.
/// \throws what makeWorkspace or body throws first; rounds that have not begun are left out.
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
