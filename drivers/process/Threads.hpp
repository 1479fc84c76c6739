#pragma once

#include <string>

namespace epafi::drivers {

class Ranks;

/// Largest number of threads; the stacks of more would take all memory.
constexpr int mostThreads = 4096;

/// Limits the threads of parallel loops (bem/base/Parallel) and of BLAS.
void setThreads(int threads);

/// Sets the number of threads to `wanted`; 0: the default, which is all cores or the
/// value of the environment, but one per process under mpirun.
void chooseThreads(int wanted, const Ranks& ranks);

/// The largest number of threads of a parallel loop.
int threads();

/// The name of the kernels that OpenBLAS chose; "unknown" for another BLAS.
std::string blasCore();

/// Sets environment variables of OpenBLAS and lets it read them again:
///
///   OPENBLAS_CORETYPE        if its kernels do not fit the processor: the OpenBLAS of
///                            Debian does not know newer processors and is then five
///                            times slower; the kernels are chosen again
///   OPENBLAS_THREAD_TIMEOUT  if it has threads: idle ones shall not use a processor for
///                            long; they end now and start again when needed
///
/// Call it first in main, before MPI_Init and before threads start.  Variables that the
/// user has set and other BLAS libraries are not changed.
void tuneBlas();

}  // namespace epafi::drivers
