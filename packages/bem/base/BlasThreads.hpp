#pragma once

namespace epafi::bem {

/// Limits the threads of OpenBLAS calls during its lifetime; no effect on another BLAS.  Use 1
/// in loops over many small matrices, since starting threads for each call costs much more
/// than the arithmetic, and blasThreadsFor(work) for large calls.
///
/// Not thread-safe: construct and destroy it outside of parallel loops.  In the rounds of
/// parallelFor() OpenBLAS has one thread anyway.
class BlasThreads {
 public:
  explicit BlasThreads(int most);
  ~BlasThreads();
  BlasThreads(const BlasThreads&) = delete;
  BlasThreads& operator=(const BlasThreads&) = delete;

 private:
  int before_ = 0;  ///< previous number of threads, if it was larger
};

}  // namespace epafi::bem
