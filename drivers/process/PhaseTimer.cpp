#include "drivers/process/PhaseTimer.hpp"

#include <Teuchos_DefaultSerialComm.hpp>
#include <Teuchos_StackedTimer.hpp>

#include <iomanip>
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
  step_ = 0;
  stack_->start(levelName_);
}

void PhaseTimer::endLevel() {
  if (!levelName_.empty())
    stack_->stop(levelName_);
  levelName_.clear();
}

void PhaseTimer::startStep(int step, int steps) {
  step_ = step;
  steps_ = steps;
  if (step == 1)
    stepsBegin_ = wallSeconds();
}

void PhaseTimer::tell(const std::string& progress) {
  std::ostringstream text;
  text << levelName_ << std::fixed << std::setprecision(1);
  if (step_ > 0)
    text << ", step " << step_ << " of " << steps_;
  text << ": " << progress << " (" << wallSeconds() << " s so far";
  const double left =
      step_ > 1 ? (wallSeconds() - stepsBegin_) / (step_ - 1) * (steps_ - step_ + 1) : 0;
  if (left >= 1)
    text << ", the level's steps take some " << std::setprecision(0) << left << " s more";
  text << ")";
  watch_(text.str());
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
