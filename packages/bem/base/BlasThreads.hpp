#pragma once

namespace epafi::bem {

/// While it lives, each call of OpenBLAS takes at most so many threads; another BLAS is left
/// alone.  One for loops that call BLAS for many small matrices: where each call has threads
/// of its own they wait for one another, twenty times as long as they compute.  For a call
/// that may be large: blasThreadsFor(its work).
///
/// Not for several threads at once: it is made and ends outside of their loops, or changes
/// nothing, as OpenBLAS has one thread in the rounds of parallelFor().
class BlasThreads {
 public:
  explicit BlasThreads(int most);
  ~BlasThreads();
  BlasThreads(const BlasThreads&) = delete;
  BlasThreads& operator=(const BlasThreads&) = delete;

 private:
  int before_ = 0;  ///< threads of OpenBLAS if they were more
};

}  // namespace epafi::bem
