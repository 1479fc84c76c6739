#include "drivers/run/Levels.hpp"

#include "adaptivity/estimate/ResidualEstimator.hpp"
#include "bem/base/Error.hpp"
#include "bem/operators/ExactRotation.hpp"
#include "bem/operators/SteklovPoincare.hpp"
#include "contact/compressed/CompressedStiffness.hpp"
#include "contact/solve/DefectCorrection.hpp"
#include "contact/system/ContactSystem.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/run/BodySpaces.hpp"
#include "drivers/run/LevelPlan.hpp"
#include "drivers/run/Path.hpp"
#include "drivers/run/SolvedBodies.hpp"
#include "drivers/run/Solver.hpp"
#include "drivers/run/UnheldMotions.hpp"
#include "drivers/run/Whole.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

namespace {

/// The smallest that a body with stabilised contact has got; zero if there is none.
double gamma0Of(const contact::ContactSystem& system) {
  double smallest = 0;
  for (std::size_t b = 0; b < system.size(); ++b) {
    const double own = system.body(b).gamma0();
    if (own > 0 && (smallest == 0 || own < smallest))
      smallest = own;
  }
  return smallest;
}

std::string capReached(int level, const Size& size, long cap) {
  std::string text =
      bem::message("level ", level, " would have ", size.dof(),
                   " degrees of freedom; Adaptivity->Maximum Degrees of Freedom = ", cap);
  if (level == 0)
    throw bem::InputError(text + " does not allow a single level");
  return text;
}

bem::SteklovPoincare stiffnessOf(bem::Operators operators,
                                 const bem::SingleLayerSolver* krylov,
                                 const bem::LocalCompliance& compliance) {
  if (krylov != nullptr)
    return bem::SteklovPoincare(std::move(operators), *krylov, compliance);
  return bem::SteklovPoincare(std::move(operators), compliance);
}

/// Of each body the largest indicators over some states; returns each state's own estimate.
bem::Vector estimate(const Ground& ground, const std::vector<const SolvedBodies*>& states,
                     Level& level) {
  bem::Vector estimates(states.size(), 0.0);
  for (std::size_t b = 0; b < level.bodies.size(); ++b) {
    std::vector<adaptivity::Estimated> ofBody;
    ofBody.reserve(states.size());
    for (const SolvedBodies* solved : states)
      ofBody.push_back({solved->bodies()[b], solved->densities()[b]});
    std::vector<adaptivity::Indicators> all = adaptivity::estimateResiduals(
        ofBody, ground.lames[b], ground.scene.adaptivity.estimator, ground.processes);
    for (adaptivity::Indicators& one : all)
      for (adaptivity::Contributions& squares : one.squares)
        for (double& square : squares)
          square *= ground.scene.symmetry.copies();
    for (std::size_t k = 0; k < all.size(); ++k)
      estimates[k] = std::hypot(estimates[k], all[k].estimate());
    level.bodies[b].indicators = adaptivity::largest(all);
  }
  return estimates;
}

/// See Level::relativeEstimate; `strainEnergies`: of each state, in the user's units.
double relative(const bem::Vector& estimates, const bem::Vector& strainEnergies,
                const bem::Processes& processes) {
  const double largest = *std::max_element(strainEnergies.begin(), strainEnergies.end());
  double result = 0;
  for (std::size_t k = 0; k < estimates.size(); ++k)
    if (estimates[k] > 0)
      result = std::max(result, estimates[k] / std::sqrt(2 * std::max(strainEnergies[k],
                                                                      largest / 100)));
  return processes.broadcast({result}).front();
}

/// A level that is solved now.
struct NewLevel {
  const Size& size;
  const Plan& plan;
  PhaseTimer& timer;
  const std::function<void(const SolvedLevel&)>& handOut;
  const std::function<void(const SolvedLevel&)>& handOutStep;
  std::string note{};
  bool insteadOfCompressed = false;

  const char* operators() const {
    return plan.compressed ? "compressed" : insteadOfCompressed ? denseInstead : "dense";
  }
};

/// What comes of one: a level, or why another one has to take its place, of which nothing is
/// handed out.
using Attempt = std::variant<Level, std::string>;

/// CPU seconds and memory until now, of all processes.
void addTimes(const bem::Processes& processes, const PhaseTimer& timer, LevelRow& row) {
  const auto& phases = timer.levelSeconds();
  bem::Vector cost(phases.begin(), phases.end());
  cost.insert(cost.end(), {cpuSeconds(), timer.wallSeconds(), peakMemory()});
  cost = largestOverRanks(processes, cost);
  std::copy_n(cost.begin(), phaseCount, row.seconds.begin());
  row.secondsTotal = cost[phaseCount];
  row.secondsWall = cost[phaseCount + 1];
  row.memory = cost[phaseCount + 2];
}

LevelRow makeRow(const Ground& ground, const Level& level, const NewLevel& begun,
                 const SolvedBodies& solved, const contact::Report& report,
                 double energyFriction) {
  LevelRow row;
  row.level = level.number;
  row.size = begun.size;
  row.operators = begun.operators();
  row.note = begun.note;
  row.defect = solved.at().defect;
  row.bodies = contact::summarizeAll(solved.bodies());
  row.rigid = solved.rigidRows();
  row.summary = wholeOf(ground.scene.symmetry, contact::sumOf(row.bodies));
  row.bodies = wholeBodies(ground.scene, std::move(row.bodies));
  row.energyFriction = energyFriction;
  row.energyInterface = solved.interfaceEnergy();
  row.report = report;
  row.reason = level.reason;
  row.estimate = level.estimate();
  row.relativeEstimate = level.relativeEstimate;
  row.worstEstimate = row.estimate;
  row.squares = level.squares();
  addTimes(ground.processes, begun.timer, row);
  return row;
}

/// The level at the end of the path so far; everything but the indicators and its points.
Level levelOf(const Ground& ground, const Path& path) {
  Level level = path.last().solved->level(ground.level);
  level.status = path.report.status;
  level.reason = path.reason;
  return level;
}

std::vector<StepFields> fieldsOf(const Path& path) {
  std::vector<StepFields> steps;
  for (const auto& step : path.steps)
    steps.push_back({step->row.t, step->solved->placement().displacements,
                     step->solved->densities(), step->solved->states(),
                     step->solved->at().rigid});
  return steps;
}

std::vector<const SolvedBodies*> statesOf(const Path& path) {
  std::vector<const SolvedBodies*> states;
  for (const auto& step : path.steps)
    states.push_back(step->solved.get());
  return states;
}

/// Levels outside, steps inside: the whole path on one mesh.
Attempt solvePath(const Ground& ground, const contact::ContactSystem& atZero,
                  const std::vector<PathPoint>& earlier, const NewLevel& begun) {
  PhaseTimer& timer = begun.timer;
  const Path path = followPath(ground, atZero, earlier, timer, [&](const Path& sofar) {
    const bool another = begun.plan.denseInstead && !sofar.last().row.converged;
    if (!begun.handOutStep || another)
      return;
    timer.run(Phase::Results, [&] {
      Level level = levelOf(ground, sofar);
      level.complete = false;
      for (BodyLevel& body : level.bodies)
        body.indicators.squares.resize(body.pieces.size());
      const SolvedBodies& solved = *sofar.last().solved;
      LevelRow times;
      addTimes(ground.processes, timer, times);
      begun.handOutStep({solved.bodies(), level, times, &sofar});
    });
  });
  atZero.numbers().flexibility.release();  // estimates take as much
  if (begun.plan.denseInstead && !path.report.converged())
    return path.reason;
  const SolvedBodies& solved = *path.last().solved;
  Level level = levelOf(ground, path);
  level.path = path.points;
  level.steps = fieldsOf(path);
  const bem::Vector estimates =
      timer.run(Phase::Estimate, [&] { return estimate(ground, statesOf(path), level); });
  bem::Vector energies;
  for (const auto& step : path.steps)
    energies.push_back(step->row.energyStrain);
  level.relativeEstimate = relative(estimates, energies, ground.processes);
  timer.run(Phase::Results, [&] {
    LevelRow row = makeRow(ground, level, begun, solved, path.report,
                           path.last().row.energyDissipated);
    row.gamma0 = gamma0Of(atZero);
    const auto worst = std::max_element(estimates.begin(), estimates.end());
    row.worstStep = 1 + static_cast<int>(worst - estimates.begin());
    row.worstEstimate = *worst;
    begun.handOut({solved.bodies(), level, row, &path});
  });
  return level;
}

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
  system.numbers().flexibility.release();  // estimates take as much
  const SolvedBodies solved(ground, system, conditions, std::move(at));
  Level level = solved.level(ground.level);
  level.status = report.status;
  level.reason = outcome.reason;
  const bem::Vector estimates =
      timer.run(Phase::Estimate, [&] { return estimate(ground, {&solved}, level); });
  level.relativeEstimate =
      relative(estimates,
               {wholeOf(ground.scene.symmetry,
                        contact::sumOf(contact::summarizeAll(solved.bodies())))
                    .energyStrain},
               ground.processes);
  timer.run(Phase::Results, [&] {
    LevelRow row = makeRow(ground, level, begun, solved, report, solved.frictionWork());
    row.gamma0 = gamma0Of(system);
    begun.handOut({solved.bodies(), level, row});
  });
  return level;
}

/// The operators of all bodies as they are planned, ready to solve with.
std::vector<bem::SteklovPoincare> stiffnessesOf(const Scene& scene,
                                                const BodySpaces& spaces,
                                                const std::vector<bem::Lame>& lames,
                                                const bem::Processes& processes,
                                                const bem::SingleLayerSolver* krylov,
                                                const NewLevel& begun) {
  const bem::Units units = scene.units();
  const std::size_t count = spaces.size();
  if (begun.plan.compressed)
    return begun.timer.run(Phase::Factorization, [&] {
      std::vector<contact::CompressedInput> bodies;
      for (std::size_t b = 0; b < count; ++b)
        bodies.push_back(
            {spaces.space(b), spaces.multiplier(b), lames[b], spaces.opposite(b).get()});
      return contact::makeCompressedStiffness(bodies, scene.stabilization, units,
                                              processes, scene.linear.compression);
    });
  auto operators = begun.timer.run(Phase::Assembly, [&] {
    std::vector<bem::Operators> all;
    for (std::size_t b = 0; b < count; ++b)
      all.push_back(bem::withExactRotation(
          bem::assembleOperators(
              spaces.space(b), lames[b],
              contact::tractionElements(spaces.multiplier(b), scene.stabilization)),
          spaces.space(b)));
    return all;
  });
  return begun.timer.run(Phase::Factorization, [&] {
    std::vector<bem::SteklovPoincare> all;
    for (std::size_t b = 0; b < count; ++b)
      all.push_back(
          stiffnessOf(std::move(operators[b]), krylov,
                      contact::densityCompliance(spaces.space(b), spaces.multiplier(b),
                                                 scene.stabilization, lames[b], units)));
    return all;
  });
}

/// A level's operators, its system and its solution.
Attempt solveLevel(const Scene& scene, const BodySpaces& spaces,
                   const bem::Processes& processes, const bem::SingleLayerSolver* krylov,
                   const LevelStart& from, const NewLevel& begun) {
  std::vector<bem::Lame> lames;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    lames.push_back(scene.lame(b));
  const contact::MultiplierBasis& basis = contact::multiplierBasis(scene.multiplier);
  const auto stiffness = stiffnessesOf(scene, spaces, lames, processes, krylov, begun);
  const Ground ground{scene, from.level, spaces, lames, stiffness, processes};
  // a path starts with the conditions at t = 0
  const double start = scene.history ? 0 : 1;
  const std::vector<contact::Conditions> first = spaces.conditionsAt(start);
  const auto system = begun.timer.run(Phase::Stabilization, [&] {
    std::vector<contact::ContactProblem::Input> inputs;
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
    if (size.dof() > scene.adaptivity.limits.degreesOfFreedom)
      return {
          contact::Status::Converged,
          capReached(number, size, scene.adaptivity.limits.degreesOfFreedom) + missing};
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
