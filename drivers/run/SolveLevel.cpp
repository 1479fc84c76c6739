#include "drivers/run/SolveLevel.hpp"

#include "contact/solve/DefectCorrection.hpp"
#include "contact/system/ContactSystem.hpp"
#include "drivers/run/LevelEstimate.hpp"
#include "drivers/run/LevelRow.hpp"
#include "drivers/run/Path.hpp"
#include "drivers/run/SolvedBodies.hpp"
#include "drivers/run/Solver.hpp"
#include "drivers/run/Stiffness.hpp"
#include "drivers/run/UnheldMotions.hpp"
#include "drivers/run/Whole.hpp"

#include <algorithm>

namespace epafi::drivers {

namespace {

/// The solved equations of a level: of one load, or of the steps of a path.
struct Solutions {
  std::vector<const SolvedBodies*> states;
  bem::Vector strainEnergies;  ///< of each, in the user's units
  double frictionWork;         ///< so far, likewise
  const contact::Report& report;
  const std::string& reason;  ///< empty when converged
  const Path* path = nullptr;
};

/// The level of the last state, without indicators and path.
Level levelOf(const Ground& ground, const Solutions& solutions) {
  Level level = solutions.states.back()->level(ground.level);
  level.status = solutions.report.status;
  level.reason = solutions.reason;
  return level;
}

Solutions solutionsOf(const Path& path) {
  Solutions all{{},          {},          path.last().row.energyDissipated,
                path.report, path.reason, &path};
  for (const auto& step : path.steps) {
    all.states.push_back(step->solved.get());
    all.strainEnergies.push_back(step->row.energyStrain);
  }
  return all;
}

std::vector<StepFields> fieldsOf(const Path& path) {
  std::vector<StepFields> steps;
  for (const auto& step : path.steps)
    steps.push_back({step->row.t, step->solved->placement().displacements,
                     step->solved->densities(), step->solved->states(),
                     step->solved->at().rigid});
  return steps;
}

/// Estimates the error of solved equations and hands out the level.
Level finish(const Ground& ground, const contact::ContactSystem& system,
             const Solutions& solutions, const NewLevel& begun) {
  PhaseTimer& timer = begun.timer;
  system.numbers().flexibility.release();  // estimates take as much
  Level level = levelOf(ground, solutions);
  if (solutions.path != nullptr) {
    level.path = solutions.path->points;
    level.steps = fieldsOf(*solutions.path);
  }
  const bem::Vector estimates = timer.run(Phase::Estimate, [&] {
    return estimateErrors(ground, solutions.states, solutions.strainEnergies, level);
  });
  timer.run(Phase::Results, [&] {
    const SolvedBodies& last = *solutions.states.back();
    LevelRow row = makeRow(ground, level, system, last);
    row.size = begun.size;
    row.operators = begun.operators();
    row.note = begun.note;
    row.energyFriction = solutions.frictionWork;
    row.report = solutions.report;
    if (solutions.path != nullptr) {
      const auto worst = std::max_element(estimates.begin(), estimates.end());
      row.worstStep = 1 + static_cast<int>(worst - estimates.begin());
      row.worstEstimate = *worst;
    }
    addTimes(ground.processes, timer, row);
    begun.handOut({last.bodies(), level, row, solutions.path});
  });
  return level;
}

/// Hands out the last step of a path that is not at its end.
void handOutStep(const Ground& ground, const Path& path, const NewLevel& begun) {
  Level level = levelOf(ground, solutionsOf(path));
  level.complete = false;
  for (BodyLevel& body : level.bodies)
    body.indicators.squares.resize(body.pieces.size());
  LevelRow times;
  addTimes(ground.processes, begun.timer, times);
  begun.handOutStep({path.last().solved->bodies(), level, times, &path});
}

/// All steps of a path on one mesh.
Attempt solvePath(const Ground& ground, const contact::ContactSystem& atZero,
                  const std::vector<PathPoint>& earlier, const NewLevel& begun) {
  PhaseTimer& timer = begun.timer;
  const Path path = followPath(ground, atZero, earlier, timer, [&](const Path& sofar) {
    const bool another = begun.plan.denseInstead && !sofar.last().row.converged;
    if (begun.handOutStep && !another)
      timer.run(Phase::Results, [&] { handOutStep(ground, sofar, begun); });
  });
  if (begun.plan.denseInstead && !path.report.converged())
    return path.reason;
  return finish(ground, atZero, solutionsOf(path), begun);
}

/// One load, from the start value of the level.
Attempt solveOnce(const Ground& ground, const contact::ContactSystem& system,
                  const std::vector<contact::Conditions>& conditions,
                  const LevelStart& from, const NewLevel& begun) {
  PhaseTimer& timer = begun.timer;
  const SolvedProblem outcome = timer.run(Phase::Newton, [&] {
    return solve(ground.scene, system, ground.spaces,
                 system.joined(from.start, from.rigid), ground.processes, timer);
  });
  const contact::Report& report = outcome.solution.report;
  if (begun.plan.denseInstead && !report.converged())
    return outcome.reason;
  contact::Configuration at = timer.run(Phase::Newton, [&] {
    return report.converged()
               ? contact::corrected(system, outcome.solution.state, ground.processes)
               : system.configuration(outcome.solution.state);
  });
  const SolvedBodies solved(ground, system, conditions, std::move(at));
  const contact::Summary summary = wholeOf(
      ground.scene.symmetry, contact::sumOf(contact::summarizeAll(solved.bodies())));
  return finish(
      ground, system,
      {{&solved}, {summary.energyStrain}, solved.frictionWork(), report, outcome.reason},
      begun);
}

}  // namespace

Attempt solveLevel(const Scene& scene, const BodySpaces& spaces,
                   const bem::Processes& processes, const bem::SingleLayerSolver* krylov,
                   const LevelStart& from, const NewLevel& begun) {
  std::vector<bem::Lame> lames;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    lames.push_back(scene.lame(b));
  const contact::MultiplierBasis& basis = contact::multiplierBasis(scene.multiplier);
  const auto stiffness =
      makeStiffness(scene, spaces, begun.plan.compressed, krylov, processes, begun.timer);
  const Ground ground{scene, from.level, spaces, lames, stiffness, processes};
  // a path starts with the conditions at t = 0
  const double start = scene.history ? 0 : 1;
  const std::vector<contact::Conditions> first = spaces.conditionsAt(start);
  const auto system = begun.timer.run(Phase::Stabilization, [&] {
    std::vector<contact::BodyInput> inputs;
    for (std::size_t b = 0; b < spaces.size(); ++b)
      inputs.push_back({spaces.space(b), stiffness[b], lames[b], scene.units(), first[b],
                        basis, scene.stabilization, spaces.opposite(b),
                        formedUpTo(scene.history.steps())});
    return contact::ContactSystem(inputs, scene.drivesAt(start));
  });
  checkResistance(scene, system);
  return scene.history ? solvePath(ground, system, from.path, begun)
                       : solveOnce(ground, system, first, from, begun);
}

}  // namespace epafi::drivers
