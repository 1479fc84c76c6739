#pragma once

#include <string>

namespace epafi::drivers {

/// Memory that this process can still allocate [MiB]: the minimum of the free memory of
/// the machine, the limits of its control groups (v1 and v2; caches count as free) and
/// its limit on address space.
///
/// `root`: prefix of /proc and /sys, for tests.
double freeMemory(const std::string& root = "");

/// Lets the heap keep up to 16 MiB of freed memory: by default glibc returns it, and the
/// system clears each page again for the next level.  Blocks from 4 MiB on are mapped.
void keepFreedMemory();

/// Resident memory of this process now [MiB].
double ownMemory();

/// CPU seconds of this process since it started, all threads.
double cpuSeconds();

/// Elapsed seconds since the start of this process, in steps of 0.01 s.
double secondsSinceStart();

/// Largest resident memory of this process so far [MiB].
double peakMemory();

}  // namespace epafi::drivers
