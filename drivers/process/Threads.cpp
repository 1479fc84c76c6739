#include "drivers/process/Threads.hpp"

#include "drivers/process/Ranks.hpp"

#include <algorithm>
#include <dlfcn.h>
#include <omp.h>

namespace epafi::drivers {

void setThreads(int threads) {
  omp_set_num_threads(threads);
  // null where the BLAS that is loaded is not OpenBLAS
  if (void* const set = dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))
    reinterpret_cast<void (*)(int)>(set)(threads);
}

void chooseThreads(int wanted, const Ranks& ranks) {
  if (wanted > 0 || ranks.underMpirun())
    setThreads(std::max(wanted, 1));
}

int threads() { return omp_get_max_threads(); }

}  // namespace epafi::drivers
