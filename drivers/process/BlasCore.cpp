#include "drivers/process/BlasCore.hpp"

#include <algorithm>
#include <cstdlib>
#include <dlfcn.h>
#include <iterator>
#include <string>
#include <unistd.h>
#include <vector>

namespace epafi::drivers {

namespace {

constexpr const char* coreVariable = "OPENBLAS_CORETYPE";
constexpr const char* waitVariable = "OPENBLAS_THREAD_TIMEOUT";
constexpr const char* guardVariable = "EPAFI_BLAS_RESTARTED";

/// log2 of the cycles that a thread of OpenBLAS without work keeps asking for some: 20
/// microseconds.  OpenBLAS' own 20 milliseconds take the processor from OpenMP's threads
/// in between, so that on small levels two threads are slower than one.
constexpr const char* shortWait = "16";

/// A function of the BLAS that is loaded, null if that is not OpenBLAS.
template <class Function>
Function* blasFunction(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

/// The kernels that suit this processor and its operating system; null: any will do.
const char* fittingCore() {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512cd"))
    return "SkylakeX";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return "Haswell";
#endif
  return nullptr;
}

/// Is what OpenBLAS chose as good as what fits?
bool isAsGood(const std::string& chosen, const std::string& fitting) {
  const char* wide[] = {"SkylakeX", "Cooperlake", "Sapphirerapids"};
  const char* avx2[] = {"Haswell", "Zen", "Excavator"};
  const auto listed = [&](const auto& names) {
    return std::find(std::begin(names), std::end(names), chosen) != std::end(names);
  };
  return listed(wide) || (fitting == "Haswell" && listed(avx2));
}

}  // namespace

void restartWithFastBlas(char* const argv[]) {
  if (std::getenv(guardVariable) != nullptr)
    return;
  std::vector<const char*> set;
  const auto propose = [&](const char* variable, const char* value) {
    if (std::getenv(variable) == nullptr && setenv(variable, value, 1) == 0)
      set.push_back(variable);
  };
  const auto coreName = blasFunction<char*()>("openblas_get_corename");
  const char* fitting = fittingCore();
  if (coreName != nullptr && fitting != nullptr && !isAsGood(coreName(), fitting))
    propose(coreVariable, fitting);
  const auto threadsOfBlas = blasFunction<int()>("openblas_get_num_threads");
  if (threadsOfBlas != nullptr && threadsOfBlas() > 1)
    propose(waitVariable, shortWait);
  if (set.empty())
    return;
  setenv(guardVariable, "1", 1);
  execv("/proc/self/exe", argv);
  for (const char* variable : set)  // no /proc: go on as we are
    unsetenv(variable);
}

}  // namespace epafi::drivers
