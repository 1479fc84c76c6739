#pragma once

namespace epafi::drivers {

/// Restarts the program with what OpenBLAS reads when it loads:
///
///   OPENBLAS_CORETYPE        if it has chosen kernels below what the processor has:
///                            Debian's does not know newer processors and then computes
///                            five times slower
///   OPENBLAS_THREAD_TIMEOUT  if it has threads: they shall not wait at OpenMP's expense
///
/// Call it first in main, before MPI_Init and threads.  Happens once at most; a user's
/// own variables and another BLAS are left alone, and so is everything where
/// EPAFI_BLAS_RESTARTED is set (for emulators, whose /proc/self/exe is not the program).
/// Returns if there is nothing to do, or if the restart fails.
void restartWithFastBlas(char* const argv[]);

}  // namespace epafi::drivers
