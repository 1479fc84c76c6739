#include "drivers/process/ProgressLine.hpp"

#include <cstdio>
#include <unistd.h>

namespace epafi::drivers {

void ProgressLine::show(const std::string& what) const {
  if (progress_ == Progress::Silent)
    return;
  std::fprintf(stderr, "\r\033[K%s", what.c_str());
  std::fflush(stderr);
}

Progress progressIf(bool wants) {
  return wants && isatty(STDERR_FILENO) != 0 ? Progress::Shown : Progress::Silent;
}

}  // namespace epafi::drivers
