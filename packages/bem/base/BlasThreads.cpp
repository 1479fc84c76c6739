#include "bem/base/BlasThreads.hpp"

#include <dlfcn.h>

namespace epafi::bem {

namespace {

/// OpenBLAS' own functions, null where another BLAS is loaded.
struct OpenBlas {
  int (*threads)() = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT,
                                                       "openblas_get_num_threads"));
  void (*setThreads)(int) =
      reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
};

const OpenBlas& openBlas() {
  static const OpenBlas functions;
  return functions;
}

}  // namespace

BlasThreads::BlasThreads(int most) {
  if (openBlas().threads == nullptr || openBlas().setThreads == nullptr)
    return;
  const int now = openBlas().threads();
  if (now <= most)
    return;
  before_ = now;
  openBlas().setThreads(most);
}

BlasThreads::~BlasThreads() {
  if (before_ > 0)
    openBlas().setThreads(before_);
}

}  // namespace epafi::bem
