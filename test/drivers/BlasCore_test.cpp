#include "bem/algebra/Products.hpp"
#include "drivers/process/Threads.hpp"

#include <Teuchos_UnitTestHarness.hpp>

#include <algorithm>
#include <cstdlib>
#include <dlfcn.h>
#include <string>

namespace epafi::drivers {
namespace {

template <class Function>
Function* ofBlas(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

// Debian's OpenBLAS is what this is for: that its functions are found is part of the claim.
TEUCHOS_UNIT_TEST(BlasCore, takesTheUsersKernelsAndShortWaitsWhileRunning) {
  const auto chooseKernels = ofBlas<void()>("gotoblas_dynamic_init");
  const auto dropKernels = ofBlas<void()>("gotoblas_dynamic_quit");
  const auto setThreads = ofBlas<void(int)>("openblas_set_num_threads");
  const auto readVariables = ofBlas<void()>("openblas_read_env");
  const auto threads = ofBlas<int()>("openblas_get_num_threads");
  const auto timeout = ofBlas<unsigned()>("openblas_thread_timeout");
  const auto core = ofBlas<char*()>("openblas_get_corename");
  TEST_ASSERT(chooseKernels != nullptr && dropKernels != nullptr &&
              setThreads != nullptr && readVariables != nullptr && threads != nullptr &&
              timeout != nullptr && core != nullptr);
  const int before = threads();
  unsetenv("OPENBLAS_THREAD_TIMEOUT");
  setenv("OPENBLAS_CORETYPE", "Prescott", 1);
  setThreads(2);
  readVariables();
  dropKernels();
  chooseKernels();
  TEST_EQUALITY(std::string(core()), "Prescott");
  TEST_EQUALITY(timeout(), 0u);

  tuneBlas();
  TEST_EQUALITY(std::string(core()), "Prescott");  // the user's own
  TEST_EQUALITY(timeout(), 16u);

  setenv("OPENBLAS_THREAD_TIMEOUT", "20", 1);
  readVariables();
  unsetenv("OPENBLAS_CORETYPE");
  tuneBlas();
  TEST_EQUALITY(timeout(), 20u);  // likewise
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    TEST_INEQUALITY(std::string(core()), "Prescott");
#endif
  // with the new kernels, on threads that begin again
  constexpr bem::Index n = 1000;
  bem::Matrix ones(n, n);
  std::fill_n(ones.data(), ones.stride() * n, 1.0);
  const bem::Matrix product = bem::transposedProduct(ones, ones);
  for (const bem::Index i : {0, 500, 999})
    TEST_EQUALITY(product(i, n - 1 - i), static_cast<double>(n));
  setThreads(before);
}

}  // namespace
}  // namespace epafi::drivers
