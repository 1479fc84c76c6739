#pragma once

#include <string>

namespace epafi::drivers {

/// SIGINT or SIGTERM came; thrown between two phases of a run, when all files are whole.
struct Interrupted {
  int signal = 0;
  std::string advice;  ///< what was said last by adviseOnInterrupt
};

/// How long a phase may go on after a signal.
enum class Grace {
  Second,  ///< 1 s
  None     ///< under mpirun, which soon kills its ranks
};

/// Whether this process says anything: one of several ranks does.
enum class Voice { Loud, Silent };

/// From now on the first SIGINT or SIGTERM is noted, and ends the program between two
/// phases, or within the grace: then at once, with the advice on standard error and exit
/// code 128 + signal, as the second signal does.  Files are whole in any case.  A file that
/// is too large no longer ends the program.
void catchSignals(Grace grace, Voice voice);

/// What to say from now on if the program is interrupted: what is kept, and how to go on.
void adviseOnInterrupt(const std::string& advice);

/// \throws Interrupted if a signal has come.
void throwIfInterrupted();

}  // namespace epafi::drivers
