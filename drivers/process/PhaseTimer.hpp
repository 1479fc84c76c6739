#pragma once

#include "drivers/process/Resources.hpp"

#include <Teuchos_RCP.hpp>

#include <array>
#include <chrono>
#include <functional>
#include <string>

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
  /// Is told ahead of each phase what begins, and of long ones how far they are; what it throws
  /// ends the run there.
  using Watch = std::function<void(const std::string& phase)>;
  explicit PhaseTimer(Watch watch = [](const std::string&) {});
  ~PhaseTimer();

  void startLevel(int level);
  void endLevel();
  /// The step of a path that begins, from 1 on; the watch is told what the others may take.
  void startStep(int step, int steps);

  /// work(), timed.
  template <class Work>
  auto run(Phase phase, const Work& work) {
    const Scope scope(*this, phase);
    return work();
  }

  /// Tells the watch how far a phase is.
  void tell(const std::string& progress);

  /// CPU seconds of the phases, all threads: of this level, of all.
  const std::array<double, phaseCount>& levelSeconds() const { return level_; }
  double totalSeconds(Phase phase) const { return total_[at(phase)]; }
  /// Since construction, by the clock on the wall.
  double wallSeconds() const {
    return std::chrono::duration<double>(Clock::now() - begin_).count();
  }

  /// What timings.txt says, first how long the process took to get to this object: loading
  /// libraries, reading and checking.  Ends the timing.
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
  int step_ = 0;  ///< of `steps_`, where there is a path
  int steps_ = 0;
  double stepsBegin_ = 0;  ///< of this level [s]
  std::array<double, phaseCount> level_{};
  std::array<double, phaseCount> total_{};
};

}  // namespace epafi::drivers
