#pragma once

#include "drivers/process/Ranks.hpp"

#include <exception>

namespace epafi::drivers {

/// The exit code of work() on the first rank; the others wait and end as it does.
/// Collective.  Throws there what work throws.
template <class Work>
int onFirstRank(const Ranks& ranks, const Work& work) {
  int code = 0;
  std::exception_ptr problem;
  if (ranks.isFirst()) {
    try {
      code = work();
    } catch (...) {
      problem = std::current_exception();
    }
  }
  code = static_cast<int>(ranks.algebra().broadcast({static_cast<double>(code)}).front());
  if (problem)
    std::rethrow_exception(problem);
  return code;
}

}  // namespace epafi::drivers
