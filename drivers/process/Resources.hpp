#pragma once

#include <string>

namespace epafi::drivers {

/// What this process can still get before the kernel ends something [MiB]: the least of what
/// the machine has free, what the control groups that it belongs to allow (v2 and v1; caches
/// count as free), and its own limit on addresses.
///
/// `root`: stands before /proc and /sys, for tests.
double freeMemory(const std::string& root = "");

/// Has the heap keep up to 16 MiB that are free, for the next level: by itself glibc gives them
/// back, and the system clears every page again.  Blocks of 4 MiB and more are mapped.
void keepFreedMemory();

/// Resident memory of this process now [MiB].
double ownMemory();

/// CPU seconds of this process since it started, all threads.
double cpuSeconds();

/// Seconds by the clock since this process started, counted in hundredths.
double secondsSinceStart();

/// Largest resident memory of this process so far [MiB].
double peakMemory();

}  // namespace epafi::drivers
