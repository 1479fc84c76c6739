#pragma once

#include <cstdio>
#include <string>
#include <unistd.h>

namespace epafi::drivers {

/// A line on the terminal with the current activity; each text replaces the one before.
class ProgressLine {
 public:
  /// Shown only if standard error is a terminal and `wants` is true.
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
  /// Erases the line before other output.
  void clear() const { show(""); }

 private:
  bool isShown_;
};

}  // namespace epafi::drivers
