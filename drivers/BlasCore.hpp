#pragma once

namespace epafi::drivers {

/// Restarts the program with OPENBLAS_CORETYPE set if OpenBLAS has chosen kernels below
/// what the processor has: Debian's does not know newer processors and then computes five
/// times slower.  [design.md 3.5]
///
/// Call it first in main, before MPI_Init and threads: the variable is read when the
/// library loads.  Happens once at most; a user's own OPENBLAS_CORETYPE and another BLAS
/// are left alone.  Returns if there is nothing to do, or if the restart fails.
void restartWithFastBlas(char* const argv[]);

/// Threads of OpenMP and BLAS together.
void setThreads(int threads);

/// What OpenMP will use.
int threads();

}  // namespace epafi::drivers
