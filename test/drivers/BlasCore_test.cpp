#include "bem/algebra/LapackAlgebra.hpp"
#include "drivers/process/Threads.hpp"

#include <Teuchos_UnitTestHarness.hpp>

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
  const auto load = ofBlas<void()>("gotoblas_init");
  const auto unload = ofBlas<void()>("gotoblas_quit");
  const auto threads = ofBlas<int()>("openblas_get_num_threads");
  const auto timeout = ofBlas<unsigned()>("openblas_thread_timeout");
  const auto core = ofBlas<char*()>("openblas_get_corename");
  TEST_ASSERT(load != nullptr && unload != nullptr && threads != nullptr &&
              timeout != nullptr && core != nullptr);
  unsetenv("OPENBLAS_THREAD_TIMEOUT");
  setenv("OPENBLAS_CORETYPE", "Prescott", 1);
  setenv("OPENBLAS_NUM_THREADS", "2", 1);
  unload();
  load();
  TEST_EQUALITY(std::string(core()), "Prescott");
  TEST_EQUALITY(timeout(), 0u);

  tuneBlas();
  TEST_EQUALITY(std::string(core()), "Prescott");  // the user's own
  if (threads() > 1)
    TEST_EQUALITY(timeout(), 16u);

  setenv("OPENBLAS_THREAD_TIMEOUT", "20", 1);
  unsetenv("OPENBLAS_CORETYPE");
  tuneBlas();
  TEST_EQUALITY(timeout(), 20u);  // likewise
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    TEST_INEQUALITY(std::string(core()), "Prescott");
#endif
  bem::Matrix a(1, 1);
  a(0, 0) = 4;
  const bem::Vector x =
      bem::LapackAlgebra().cholesky(std::move(a), "four")->solve(bem::Vector{8});
  TEST_FLOATING_EQUALITY(x[0], 2.0, 1e-15);
}

}  // namespace
}  // namespace epafi::drivers
