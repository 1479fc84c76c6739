// Takes the place of drivers/process/Interrupt.cpp in a program for tests: at the n-th phase of a
// run, rank r fails.  EPAFI_FAULT = "n r error", "n r memory", or "n r busy": then the
// other ranks are in the midst of a long computation.
#include "bem/base/Error.hpp"
#include "drivers/process/Interrupt.hpp"

#include <chrono>
#include <cstdlib>
#include <new>
#include <sstream>
#include <string>
#include <thread>

namespace epafi::drivers {

void catchSignals(Grace, Voice) {}

void adviseOnInterrupt(const std::string&) {}

void throwIfInterrupted() {
  static int calls = 0;
  int phase = -1;
  int rank = -1;
  std::string kind;
  const char* fault = std::getenv("EPAFI_FAULT");
  std::istringstream(fault == nullptr ? "" : fault) >> phase >> rank >> kind;
  if (calls++ != phase)
    return;
  const char* me = std::getenv("OMPI_COMM_WORLD_RANK");
  if (me != nullptr && std::atoi(me) != rank) {
    if (kind == "busy")
      std::this_thread::sleep_for(std::chrono::seconds(30));
    return;
  }
  if (kind == "memory")
    throw std::bad_alloc();
  throw bem::NumericalError("injected fault");
}

}  // namespace epafi::drivers
