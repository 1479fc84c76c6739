#include "bem/base/BlasThreads.hpp"

#include <algorithm>
#include <dlfcn.h>
#include <mutex>
#include <set>

namespace epafi::bem {

namespace {

/// OpenBLAS' own functions, null where another BLAS is loaded.
struct OpenBlas {
  int (*threads)() = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT,
                                                       "openblas_get_num_threads"));
  void (*setThreads)(int) =
      reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
};

/// The limits that hold now, of all threads of the application, since OpenBLAS has one number
/// for the process.
class Limits {
 public:
  void add(int most) {
    const std::lock_guard<std::mutex> lock(changing_);
    if (blas_.threads == nullptr || blas_.setThreads == nullptr)
      return;
    if (held_.empty())
      unlimited_ = blas_.threads();
    held_.insert(most);
    apply();
  }
  void remove(int most) {
    const std::lock_guard<std::mutex> lock(changing_);
    if (held_.empty())
      return;
    held_.erase(held_.find(most));
    apply();
  }

 private:
  void apply() const {
    const int now = held_.empty() ? unlimited_ : std::min(unlimited_, *held_.begin());
    if (now != blas_.threads())
      blas_.setThreads(now);
  }

  const OpenBlas blas_{};
  std::mutex changing_;
  std::multiset<int> held_;
  int unlimited_ = 1;
};

Limits& limits() {
  static Limits all;
  return all;
}

}  // namespace

BlasThreads::BlasThreads(int most) : most_(most) { limits().add(most_); }

BlasThreads::~BlasThreads() { limits().remove(most_); }

}  // namespace epafi::bem
