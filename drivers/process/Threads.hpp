#pragma once

namespace epafi::drivers {

/// Threads of OpenMP and BLAS together.
void setThreads(int threads);

/// What OpenMP will use.
int threads();

}  // namespace epafi::drivers
