#include "drivers/process/Threads.hpp"

#include "drivers/process/Ranks.hpp"

#include <algorithm>
#include <cstdlib>
#include <dlfcn.h>
#include <iterator>
#include <omp.h>
#include <string>

namespace epafi::drivers {

namespace {

constexpr const char* coreVariable = "OPENBLAS_CORETYPE";
constexpr const char* waitVariable = "OPENBLAS_THREAD_TIMEOUT";

/// log2 of the cycles that an idle thread of OpenBLAS waits actively: 20 microseconds.
/// The default of 20 milliseconds takes the processor from other threads, so that two
/// threads are slower than one on small levels.
constexpr const char* shortWait = "16";

/// A function of the loaded BLAS; null unless it is OpenBLAS.
template <class Function>
Function* blasFunction(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

/// The name of the kernels for this processor and operating system; null: no preference.
const char* fittingCore() {
#if defined(__x86_64__)
  __builtin_cpu_init();
  // AMD family 19h executes AVX-512 in two halves: products are not faster than with the
  // AVX2 kernels of OpenBLAS, triangular solves reach only 0.65 of their speed.
  const bool hasHalves = __builtin_cpu_is("amdfam19h");
  if (!hasHalves && __builtin_cpu_supports("avx512f") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512cd"))
    return "SkylakeX";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return "Haswell";
#endif
  return nullptr;
}

/// Are the kernels that OpenBLAS chose as fast as the fitting ones?
bool isAsGood(const std::string& chosen, const std::string& fitting) {
  const char* wide[] = {"SkylakeX", "Cooperlake", "Sapphirerapids"};
  const char* avx2[] = {"Haswell", "Zen", "Excavator"};
  const auto listed = [&](const auto& names) {
    return std::find(std::begin(names), std::end(names), chosen) != std::end(names);
  };
  return fitting == "Haswell" ? listed(avx2) : listed(wide);
}

}  // namespace

void setThreads(int threads) {
  omp_set_num_threads(threads);
  if (const auto set = blasFunction<void(int)>("openblas_set_num_threads"))
    set(threads);
}

void chooseThreads(int wanted, const Ranks& ranks) {
  if (wanted > 0 || ranks.underMpirun())
    setThreads(std::max(wanted, 1));
}

int threads() { return omp_get_max_threads(); }

std::string blasCore() {
  const auto name = blasFunction<char*()>("openblas_get_corename");
  return name == nullptr ? "unknown" : name();
}

void tuneBlas() {
  const auto propose = [](const char* variable, const char* value) {
    return std::getenv(variable) == nullptr && setenv(variable, value, 1) == 0;
  };
  const auto endThreads = blasFunction<int()>("blas_thread_shutdown_");
  const auto threadsOfBlas = blasFunction<int()>("openblas_get_num_threads");
  const auto readVariables = blasFunction<void()>("openblas_read_env");
  if (endThreads != nullptr && threadsOfBlas != nullptr && readVariables != nullptr &&
      threadsOfBlas() > 1 && propose(waitVariable, shortWait)) {
    readVariables();
    endThreads();
  }
  const char* fitting = fittingCore();
  const std::string core = blasCore();
  const auto dropKernels = blasFunction<void()>("gotoblas_dynamic_quit");
  const auto chooseKernels = blasFunction<void()>("gotoblas_dynamic_init");
  if (dropKernels != nullptr && chooseKernels != nullptr && core != "unknown" &&
      fitting != nullptr && !isAsGood(core, fitting) && propose(coreVariable, fitting)) {
    dropKernels();
    chooseKernels();
  }
}

}  // namespace epafi::drivers
