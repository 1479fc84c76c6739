#include "drivers/process/Interrupt.hpp"

#include <csignal>
#include <unistd.h>

namespace epafi::drivers {

namespace {

// The one thing that a signal handler can reach.
volatile std::sig_atomic_t received = 0;

void note(int signal) {
  if (received != 0)
    _exit(128 + signal);
  received = signal;
}

}  // namespace

void catchSignals() {
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A file above the user's limit (ulimit -f) shall be an error like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
}

void throwIfInterrupted() {
  if (received != 0)
    throw Interrupted{received};
}

}  // namespace epafi::drivers
