#include "drivers/run/Levels.hpp"

#include "bem/base/Error.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/run/Path.hpp"
#include "drivers/run/SolveLevel.hpp"

namespace epafi::drivers {

namespace {

/// By attempt(plan); with dense operators where compressed ones fail and the plan lets it: which
/// is told.  Of several processes one may have broken down alone: that ends all of them.
template <class Attempts>
Level solveAnyhow(const Attempts& attempt, const Plan& plan,
                  const bem::Processes& processes) {
  std::string failure;
  try {
    Attempt first = attempt(plan);
    if (auto* level = std::get_if<Level>(&first))
      return std::move(*level);
    failure = std::get<std::string>(first);
  } catch (const bem::NumericalError& error) {
    if (!plan.denseInstead || processes.count() > 1)
      throw;
    failure = error.what();
  }
  Plan dense{false, *plan.denseInstead};
  dense.advice = "compressed operators failed, dense ones took their place: " + failure;
  dense.insteadOfCompressed = true;
  return std::get<Level>(attempt(dense));
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
  std::string missing = earlier ? missingTo(scene, *earlier) : "";
  auto next = earlier ? levelAfterRestart(scene, *earlier, processes) : firstLevel(scene);
  while (const auto* from = std::get_if<LevelStart>(&next)) {
    const int number = from->level;
    const BodySpaces spaces(scene, from->meshes);
    const Size size = spaces.totalSize();
    const std::string capReached = aboveCap(number, size, scene);
    if (!capReached.empty())
      return {contact::Status::Converged, capReached + missing};
    Plan plan = planOf(scene, spaces, ranks, allowed);
    allowed = plan.allowed;
    if (const auto reason = tooLarge(number, size, plan, scene, spaces, ranks))
      return {contact::Status::Converged, *reason + missing};
    if (advised)
      plan.advice.clear();
    advised = advised || !plan.advice.empty();
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
        [&](const Plan& by) {
          return solveLevel(scene, spaces, processes, krylov.get(), *from,
                            {by, timer, handOut, handOutNew});
        },
        plan, processes);
    timer.endLevel();
    missing = missingTo(scene, level);
    next = nextLevel(scene, level, processes);
  }
  return std::get<Outcome>(next);
}

}  // namespace epafi::drivers
