#pragma once

namespace epafi::drivers {

class Ranks;

/// More, and stacks take all of the memory.
constexpr int mostThreads = 4096;

/// Threads of OpenMP and BLAS together.
void setThreads(int threads);

/// As many as are wanted; 0: the default, all cores or what the environment says, but one for each
/// process under mpirun.
void chooseThreads(int wanted, const Ranks& ranks);

/// What OpenMP will use.
int threads();

}  // namespace epafi::drivers
