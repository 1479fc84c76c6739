#include "bem/algebra/SerialBlas.hpp"

#include <dlfcn.h>

namespace epafi::bem {

namespace {

void setBlasThreads(int threads) {
  using Set = void(int);
  if (auto* set = reinterpret_cast<Set*>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads")))
    set(threads);
}

}  // namespace

SerialBlas::SerialBlas() {
  using Get = int();
  if (auto* get = reinterpret_cast<Get*>(dlsym(RTLD_DEFAULT, "openblas_get_num_threads")))
    before_ = get();
  if (before_ > 1)
    setBlasThreads(1);
}

SerialBlas::~SerialBlas() {
  if (before_ > 1)
    setBlasThreads(before_);
}

}  // namespace epafi::bem
