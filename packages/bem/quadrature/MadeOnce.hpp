#pragma once

#include <array>
#include <atomic>
#include <cassert>
#include <mutex>

namespace epafi::bem {

/// Thread-safe cache of values for n = 1 ... Count, each computed on first use.
template <class Value, int Count>
class MadeOnce {
 public:
  explicit MadeOnce(Value (*make)(int n)) : make_(make) {}

  /// \pre 1 <= n <= Count
  const Value& operator[](int n) {
    assert(1 <= n && n <= Count);
    const std::size_t k = n - 1;
    if (!isMade_[k].load(std::memory_order_acquire)) {
      const std::lock_guard<std::mutex> lock(making_);
      if (!isMade_[k].load(std::memory_order_relaxed)) {
        values_[k] = make_(n);
        isMade_[k].store(true, std::memory_order_release);
      }
    }
    return values_[k];
  }

 private:
  Value (*make_)(int n);
  std::mutex making_;
  std::array<std::atomic<bool>, Count> isMade_{};
  std::array<Value, Count> values_{};
};

}  // namespace epafi::bem
