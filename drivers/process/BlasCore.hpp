#pragma once

namespace epafi::drivers {

/// Has OpenBLAS begin anew, as its destructor and constructor do, with better variables:
///
///   OPENBLAS_CORETYPE        if it has chosen kernels below what the processor has:
///                            Debian's does not know newer processors and then computes
///                            five times slower
///   OPENBLAS_THREAD_TIMEOUT  if it has threads: they shall not wait at OpenMP's expense
///
/// Call it first in main, before MPI_Init and threads.  A user's own variables and another
/// BLAS are left alone.
void tuneBlas();

}  // namespace epafi::drivers
