#pragma once

#include <string>

namespace epafi::drivers {

class Ranks;

/// More, and stacks take all of the memory.
constexpr int mostThreads = 4096;

/// At most so many threads for loops, see bem/base/Parallel, and for BLAS.
void setThreads(int threads);

/// As many as are wanted; 0: the default, all cores or what the environment says, but one for each
/// process under mpirun.
void chooseThreads(int wanted, const Ranks& ranks);

/// At most so many are used.
int threads();

/// The kernels that OpenBLAS chose, "unknown" for another BLAS.
std::string blasCore();

/// Sets variables that OpenBLAS reads when it is loaded, and has it read them again:
///
///   OPENBLAS_CORETYPE        if it has chosen kernels below what the processor has:
///                            Debian's does not know newer processors and then computes
///                            five times slower; the table of kernels is chosen again
///   OPENBLAS_THREAD_TIMEOUT  if it has threads: they shall not wait at others' expense;
///                            they end, and begin again when they are asked for
///
/// Call it first in main, before MPI_Init and threads.  A user's own variables and another
/// BLAS are left alone.
void tuneBlas();

}  // namespace epafi::drivers
