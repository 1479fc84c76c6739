#pragma once

#include <string>

namespace epafi::drivers {

/// Who wants to see what a run is doing.
enum class Progress { Shown, Silent };

/// One line on the terminal that says what is going on; each replaces the one before.
class ProgressLine {
 public:
  explicit ProgressLine(Progress progress) : progress_(progress) {}
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const std::string& what) const;
  /// Makes room for other output.
  void clear() const { show(""); }

 private:
  Progress progress_;
};

/// Shown if standard error is a terminal and the user `wants` to see it.
Progress progressIf(bool wants);

}  // namespace epafi::drivers
