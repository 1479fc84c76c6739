#include "drivers/process/PhaseTimer.hpp"

#include <Teuchos_DefaultSerialComm.hpp>
#include <Teuchos_StackedTimer.hpp>

#include <cstdio>
#include <sstream>
#include <utility>

namespace epafi::drivers {

const char* nameOf(Phase phase) {
  constexpr const char* names[phaseCount] = {"assembly", "factorization", "stabilization",
                                             "newton",   "estimate",      "results"};
  return names[static_cast<std::size_t>(phase)];
}

PhaseTimer::PhaseTimer(Watch watch)
    : watch_(std::move(watch)),
      stack_(Teuchos::rcp(new Teuchos::StackedTimer("epafi run"))) {}

PhaseTimer::~PhaseTimer() = default;

void PhaseTimer::startLevel(int level) {
  endLevel();
  levelName_ = "level " + std::to_string(level);
  level_.fill(0);
  stack_->start(levelName_);
}

void PhaseTimer::endLevel() {
  if (!levelName_.empty())
    stack_->stop(levelName_);
  levelName_.clear();
}

void PhaseTimer::tell(const std::string& progress) {
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, " (%.1f s so far)", wallSeconds());
  watch_(levelName_ + ": " + progress + seconds);
}

std::string PhaseTimer::report() {
  endLevel();
  stack_->stopBaseTimer();
  Teuchos::StackedTimer::OutputOptions options;
  options.output_fraction = true;
  options.print_warnings = false;
  std::ostringstream text;
  text << "start: " << start_ << "\n";
  stack_->report(text, Teuchos::rcp(new Teuchos::SerialComm<int>), options);
  return text.str();
}

PhaseTimer::Scope::Scope(PhaseTimer& timer, Phase phase)
    : timer_(timer), phase_(phase), start_(cpuSeconds()) {
  timer.tell(nameOf(phase));
  timer.stack_->start(nameOf(phase));
}

PhaseTimer::Scope::~Scope() {
  const double seconds = cpuSeconds() - start_;
  timer_.level_[at(phase_)] += seconds;
  timer_.total_[at(phase_)] += seconds;
  timer_.stack_->stop(nameOf(phase_));
}

}  // namespace epafi::drivers
