#pragma once

#include <string>

namespace epafi::drivers {

/// What this process can still get before the kernel ends something [MiB]: the least of what
/// the machine has free, what the control groups that it belongs to allow (v2 and v1; caches
/// count as free), and its own limit on addresses.
///
/// `root`: stands before /proc and /sys, for tests.
double freeMemory(const std::string& root = "");

/// Resident memory of this process now [MiB].
double ownMemory();

}  // namespace epafi::drivers
