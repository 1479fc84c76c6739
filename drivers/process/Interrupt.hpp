#pragma once

#include <string>

namespace epafi::drivers {

/// Thrown after SIGINT or SIGTERM between two phases of a run, when files are complete.
struct Interrupted {
  int signal = 0;
  std::string advice;  ///< the text of the last adviseOnInterrupt
};

/// How long a phase may go on after a signal.
enum class Grace {
  Second,  ///< 1 s
  None     ///< under mpirun, which soon kills its ranks
};

/// Does this process print messages?  Only the first of several ranks does.
enum class Voice { Loud, Silent };

/// Installs the signal handlers.  After SIGINT or SIGTERM the program ends at the next
/// phase.  After the grace or a second signal it ends at once, with the advice on
/// standard error and exit code 128 + signal.  Files are always complete.  Writing above
/// the file size limit fails but no longer ends the program.
void catchSignals(Grace grace, Voice voice);

/// Sets the message for an interrupt: what is saved, and how to continue.
void adviseOnInterrupt(const std::string& advice);

/// \throws Interrupted if a signal has been received.
void throwIfInterrupted();

}  // namespace epafi::drivers
