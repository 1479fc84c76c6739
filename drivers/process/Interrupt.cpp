#include "drivers/process/Interrupt.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <sys/time.h>
#include <unistd.h>

namespace epafi::drivers {

namespace {

// State that the signal handler may read: plain memory.  Two buffers take turns, so that
// one is complete while the other is written.
constexpr std::size_t room = 1 << 14;  // a truncated command would be wrong
std::array<std::array<char, room>, 2> advice{};
volatile std::sig_atomic_t current = 0;
volatile std::sig_atomic_t length = 0;
volatile std::sig_atomic_t received = 0;
volatile std::sig_atomic_t graceSeconds = 1;
bool speaks = true;

void startTimer() {
  itimerval time{};
  time.it_value.tv_sec = graceSeconds;
  setitimer(ITIMER_REAL, &time, nullptr);
}

void endNow(int) {
  if (!speaks)
    sleep(2);  // mpirun kills all ranks when one ends; the first rank prints before that
  const auto& text = advice[current];
  if (length > 0 &&
      write(STDERR_FILENO, text.data(), static_cast<std::size_t>(length)) < 0)
    _exit(128 + received);  // the message cannot be printed
  _exit(128 + received);
}

void note(int signal) {
  const bool second = received != 0;
  received = signal;
  if (second || graceSeconds == 0)
    endNow(signal);
  startTimer();
}

std::string told;

}  // namespace

void catchSignals(Grace grace, Voice voice) {
  speaks = voice == Voice::Loud;
  graceSeconds = grace == Grace::Second ? 1 : 0;
  struct sigaction timer {};
  timer.sa_handler = endNow;
  sigaction(SIGALRM, &timer, nullptr);
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A file above the limit of ulimit -f is then an error like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
}

void adviseOnInterrupt(const std::string& text) {
  told = text;
  const std::string line = text.empty() || !speaks ? "" : "\nepafi: " + text + "\n";
  const std::size_t other = 1 - current;
  const std::size_t size = std::min(line.size(), room);
  std::copy_n(line.begin(), size, advice[other].begin());
  length = 0;  // no text is valid while the buffers are switched
  current = static_cast<std::sig_atomic_t>(other);
  length = static_cast<std::sig_atomic_t>(size);
}

void throwIfInterrupted() {
  if (received == 0)
    return;
  startTimer();  // restart the timer: the orderly end has to wait for the other ranks
  throw Interrupted{received, told};
}

}  // namespace epafi::drivers
