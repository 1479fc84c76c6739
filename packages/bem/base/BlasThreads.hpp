#pragma once

namespace epafi::bem {

/// Limits the threads of OpenBLAS calls during its lifetime; no effect on another BLAS.  Use 1
/// in loops over many small matrices, since starting threads for each call costs much more
/// than the arithmetic, and blasThreadsFor(work) for large calls.
///
/// Several threads of an application may limit at once: the least limit holds for all, and the
/// last one to leave restores what was before.  In the rounds of parallelFor() OpenBLAS has one
/// thread anyway.
class BlasThreads {
 public:
  explicit BlasThreads(int most);
  ~BlasThreads();
  BlasThreads(const BlasThreads&) = delete;
  BlasThreads& operator=(const BlasThreads&) = delete;

 private:
  int most_;
};

}  // namespace epafi::bem
