#include "drivers/run/Levels.hpp"

#include "bem/base/Error.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/run/Path.hpp"
#include "drivers/run/SolveLevel.hpp"

namespace epafi::drivers {

namespace {

/// With dense operators where compressed ones fail and the plan lets it: which is told.  Of several
/// processes one may have broken down alone: that ends all of them.
template <class Attempts>
Level solveAnyhow(const Attempts& attempt, const NewLevel& begun,
                  const bem::Processes& processes) {
  std::string failure;
  try {
    Attempt first = attempt(begun);
    if (auto* level = std::get_if<Level>(&first))
      return std::move(*level);
    failure = std::get<std::string>(first);
  } catch (const bem::NumericalError& error) {
    if (!begun.plan.denseInstead || processes.count() > 1)
      throw;
    failure = error.what();
  }
  const Plan dense{false, *begun.plan.denseInstead};
  Size size = begun.size;
  size.memory = dense.memory;
  return std::get<Level>(attempt(NewLevel{
      size, dense, begun.timer, begun.handOut, begun.handOutStep,
      "compressed operators failed, dense ones took their place: " + failure, true}));
}

}  // namespace

Outcome solveLevels(const Scene& scene, const Ranks& ranks, PhaseTimer& timer,
                    const std::function<void(const SolvedLevel&)>& handOut,
                    const std::optional<Level>& earlier,
                    const std::function<void(const SolvedLevel&)>& handOutStep) {
  const bem::Processes& processes = ranks.processes();
  const auto krylov = linearMethods().at(scene.linear.method).solver(ranks, scene.linear);
  std::string advice;  // as it was given, once
  double allowed = 0;  // memory, as it was found
  std::string missing = earlier ? missingTo(scene, *earlier) : "";
  auto next = earlier ? levelAfterRestart(scene, *earlier, processes) : firstLevel(scene);
  while (const auto* from = std::get_if<LevelStart>(&next)) {
    const int number = from->level;
    const BodySpaces spaces(scene, from->meshes);
    Size size = spaces.totalSize();
    const std::string capReached = aboveCap(number, size, scene);
    if (!capReached.empty())
      return {contact::Status::Converged, capReached + missing};
    const Plan plan = planOf(scene, spaces, ranks, allowed);
    allowed = plan.allowed;
    size.memory = plan.memory;
    if (const auto reason = tooLarge(number, size, plan, scene, spaces, ranks))
      return {contact::Status::Converged, *reason + missing};
    timer.startLevel(number);

    std::size_t handed = 0;  // steps, which another attempt does not hand out again
    std::function<void(const SolvedLevel&)> handOutNew;
    if (handOutStep)
      handOutNew = [&](const SolvedLevel& level) {
        if (level.path->steps.size() > handed) {
          ++handed;
          handOutStep(level);
        }
      };
    const Level level = solveAnyhow(
        [&](const NewLevel& begun) {
          return solveLevel(scene, spaces, processes, krylov.get(), *from, begun);
        },
        NewLevel{size, plan, timer, handOut, handOutNew,
                 advice.empty() ? plan.advice : ""},
        processes);
    if (advice.empty())
      advice = plan.advice;
    timer.endLevel();
    missing = missingTo(scene, level);
    next = nextLevel(scene, level, processes);
  }
  return std::get<Outcome>(next);
}

}  // namespace epafi::drivers
