// Takes the place of drivers/process/Interrupt.cpp in a program for tests: at the n-th phase of a
// run, rank r fails.  EPAFI_FAULT = "n r error", "n r memory", "n r busy": then the other ranks
// are in the midst of a long computation, or "n r heap": then nothing is left for the threads
// that help, from this phase on.
#include "bem/base/Error.hpp"
#include "drivers/process/Interrupt.hpp"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <new>
#include <sstream>
#include <string>
#include <thread>

namespace {

std::atomic<bool> isHeapEmpty = false;
const std::thread::id mainThread = std::this_thread::get_id();

}  // namespace

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  if (isHeapEmpty && std::this_thread::get_id() != mainThread)
    return nullptr;
  return std::malloc(size);
}

void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow))
    return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

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
  if (kind == "heap") {
    isHeapEmpty = true;
    return;
  }
  if (kind == "memory")
    throw std::bad_alloc();
  throw bem::NumericalError("injected fault");
}

}  // namespace epafi::drivers
