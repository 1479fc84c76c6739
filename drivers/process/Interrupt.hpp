#pragma once

namespace epafi::drivers {

/// SIGINT or SIGTERM came; thrown between two phases of a run, when all files are whole.
struct Interrupted {
  int signal = 0;
};

/// From now on the first SIGINT or SIGTERM is only noted, the second ends the program at
/// once with exit code 128 + signal; a file that is too large no longer does.
void catchSignals();

/// \throws Interrupted if a signal has come.
void throwIfInterrupted();

}  // namespace epafi::drivers
