#pragma once

#include "drivers/process/Resources.hpp"

#include <Teuchos_RCP.hpp>

#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>
#include <unistd.h>

namespace Teuchos {
class StackedTimer;
}

namespace epafi::drivers {

/// The parts of a level that are timed.
enum class Phase {
  Assembly,       ///< V, K, W
  Factorization,  ///< V = L Lᵀ, S
  Stabilization,  ///< traction rows, A and its factor, the condensed problem
  Newton,
  Estimate,  ///< indicators
  Results
};
constexpr int phaseCount = 6;
const char* nameOf(Phase phase);

/// Times the phases of a run.
class PhaseTimer {
 public:
  /// Called before each phase with its name, and during long ones with their progress.
  /// An exception that it throws ends the run there.
  using Watch = std::function<void(const std::string& phase)>;
  explicit PhaseTimer(Watch watch = [](const std::string&) {});
  ~PhaseTimer();

  void startLevel(int level);
  void endLevel();
  /// Starts a step of a path, 1 <= step <= steps; messages then estimate the time left.
  void startStep(int step, int steps);

  /// Returns work() and adds its CPU time to the phase.
  template <class Work>
  auto run(Phase phase, const Work& work) {
    const Scope scope(*this, phase);
    return work();
  }

  /// Passes a message on the progress of a phase to the watch.
  void tell(const std::string& progress);

  /// CPU seconds of the phases over all threads: of this level, and of all levels.
  const std::array<double, phaseCount>& levelSeconds() const { return level_; }
  double totalSeconds(Phase phase) const { return total_[at(phase)]; }
  /// Elapsed seconds since construction.
  double wallSeconds() const {
    return std::chrono::duration<double>(Clock::now() - begin_).count();
  }

  /// Ends the timing and returns the text of timings.txt, first the seconds from the
  /// start of the process to the construction of this object.
  std::string report();

 private:
  using Clock = std::chrono::steady_clock;

  class Scope {
   public:
    Scope(PhaseTimer& timer, Phase phase);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    PhaseTimer& timer_;
    Phase phase_;
    double start_;
  };

  static std::size_t at(Phase phase) { return static_cast<std::size_t>(phase); }

  Watch watch_;
  double start_ = secondsSinceStart();
  Clock::time_point begin_ = Clock::now();
  Teuchos::RCP<Teuchos::StackedTimer> stack_;
  std::string levelName_;
  int step_ = 0;  ///< current step; 0 without a path
  int steps_ = 0;
  double stepsBegin_ = 0;  ///< begin of the first step of this level [s]
  std::array<double, phaseCount> level_{};
  std::array<double, phaseCount> total_{};
};

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
