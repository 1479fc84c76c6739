#include "drivers/run/Levels.hpp"

#include "bem/base/Error.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/run/LevelPlan.hpp"
#include "drivers/run/SolveLevel.hpp"

namespace epafi::drivers {

namespace {

/// As planned; with dense operators where compressed ones fail and the plan lets it: which is
/// told.  Of several processes one may have broken down alone: that ends all of them.
Level solveAnyhow(const BodySpaces& spaces, const Level& from, const LevelRow& planned,
                  const Run& run) {
  std::string failure;
  try {
    Attempt first = solveLevel(spaces, from, planned, run);
    if (auto* level = std::get_if<Level>(&first))
      return std::move(*level);
    failure = std::get<std::string>(first);
  } catch (const bem::NumericalError& error) {
    if (!planned.memoryOfDense || run.processes.count() > 1)
      throw;
    failure = error.what();
  }
  LevelRow dense = planned;
  dense.operators = denseInstead;
  dense.memoryForecast = *planned.memoryOfDense;
  dense.memoryOfDense.reset();
  dense.note = "compressed operators failed, dense ones took their place: " + failure;
  return std::get<Level>(solveLevel(spaces, from, dense, run));
}

}  // namespace

Outcome solveLevels(const Scene& scene, const Ranks& ranks, PhaseTimer& timer,
                    const std::function<void(const SolvedLevel&)>& handOut,
                    const std::optional<Level>& earlier,
                    const std::function<void(const SolvedLevel&)>& handOutStep) {
  const bem::Processes& processes = ranks.processes();
  const auto krylov =
      linearMethods().at(scene.solver.linear.method).solver(ranks, scene.solver.linear);
  bool advised = false;  // once
  double allowed = 0;    // memory, as it was found
  Outcome last = earlier ? ended(scene, *earlier, "") : Outcome();
  auto next = earlier ? levelAfterRestart(scene, *earlier, processes) : firstLevel(scene);
  while (const auto* from = std::get_if<Level>(&next)) {
    const BodySpaces spaces(scene, *from);
    std::string reason = aboveCap(from->number, spaces.levelRow(), scene);
    if (!reason.empty())
      return {last.status, reason + last.reason};
    LevelRow planned = planOf(spaces, ranks, allowed);
    allowed = planned.memoryAllowed;
    reason = tooLarge(from->number, planned, spaces, ranks);
    if (!reason.empty())
      return {last.status, reason + last.reason};
    if (advised)
      planned.note.clear();
    advised = advised || !planned.note.empty();
    timer.startLevel(from->number);

    std::size_t handed = 0;  // steps, which another attempt does not hand out again
    std::function<void(const SolvedLevel&)> handOutNew;
    if (handOutStep)
      handOutNew = [&](const SolvedLevel& level) {
        if (level.steps.size() > handed) {
          ++handed;
          handOutStep(level);
        }
      };
    const Level level = solveAnyhow(
        spaces, *from, planned, {processes, timer, krylov.get(), handOut, handOutNew});
    timer.endLevel();
    last = ended(scene, level, "");
    next = nextLevel(scene, level, processes);
  }
  return std::get<Outcome>(next);
}

}  // namespace epafi::drivers
