#pragma once

#include <chrono>

namespace epafi::drivers {

/// CPU seconds of this process since it started, all threads.
double cpuSeconds();

/// Largest resident memory of this process so far [MiB].
double peakMemory();

/// Wall time since the program's start.
class WallClock {
 public:
  double seconds() const;

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace epafi::drivers
