#pragma once

#include <cstdio>
#include <string>
#include <unistd.h>

namespace epafi::drivers {

/// One line on the terminal that says what is going on; each replaces the one before.
class ProgressLine {
 public:
  /// Shown if standard error is a terminal and the user `wants` to see it.
  explicit ProgressLine(bool wants) : isShown_(wants && isatty(STDERR_FILENO) != 0) {}
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const std::string& what) const {
    if (isShown_) {
      std::fprintf(stderr, "\r\033[K%s", what.c_str());
      std::fflush(stderr);
    }
  }
  /// Makes room for other output.
  void clear() const { show(""); }

 private:
  bool isShown_;
};

}  // namespace epafi::drivers
