#include "drivers/run/SolveLevel.hpp"

#include "adaptivity/estimate/ResidualEstimator.hpp"
#include "bem/operators/ExactRotation.hpp"
#include "contact/compressed/CompressedStiffness.hpp"
#include "contact/solve/DefectCorrection.hpp"
#include "drivers/process/Resources.hpp"
#include "drivers/run/Path.hpp"
#include "drivers/run/Solver.hpp"
#include "drivers/run/UnheldMotions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::drivers {

namespace {

/// The Steklov-Poincaré operators of all bodies, factored, as dense matrices or compressed.
/// \param krylov solves with V; null: its factor does
/// \throws bem::NumericalError if a factorisation breaks down
std::vector<bem::SteklovPoincare> makeStiffness(
    const Scene& scene, const BodySpaces& spaces, const std::vector<bem::Lame>& lames,
    bool compressed, const bem::SingleLayerSolver* krylov,
    const bem::Processes& processes, PhaseTimer& timer) {
  if (compressed)
    return timer.run(Phase::Factorization, [&] {
      return contact::makeCompressedStiffness(spaces.sides(), lames, scene.stabilization,
                                              scene.units(), processes,
                                              scene.solver.linear.compression);
    });
  std::vector<bem::Operators> operators = timer.run(Phase::Assembly, [&] {
    std::vector<bem::Operators> all;
    for (std::size_t b = 0; b < spaces.size(); ++b)
      all.push_back(bem::withExactRotation(
          bem::assembleOperators(spaces.space(b), lames[b]), spaces.space(b)));
    return all;
  });
  return timer.run(Phase::Factorization, [&] {
    std::vector<bem::SteklovPoincare> all;
    for (std::size_t b = 0; b < spaces.size(); ++b) {
      const bem::LocalCompliance compliance =
          contact::densityCompliance(spaces.space(b), spaces.multiplier(b),
                                     scene.stabilization, lames[b], scene.units());
      all.push_back(
          krylov != nullptr
              ? bem::SteklovPoincare(std::move(operators[b]), *krylov, compliance)
              : bem::SteklovPoincare(std::move(operators[b]), compliance));
    }
    return all;
  });
}

/// Indicators of one body in each state; of a half cut by symmetry as of the whole.
std::vector<adaptivity::Indicators> indicatorsOf(
    const Ground& ground, const std::vector<const SolvedBodies*>& states, std::size_t b) {
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
  return all;
}

/// Squared energy norms below which rounding has all digits: those of a motion without strain.
double roundingOf(const Scene& scene, const SolvedBodies& solved) {
  double motion = 0;
  for (const bem::Vector& displacement : solved.placement().displacements)
    for (const double u : displacement)
      motion = std::max(motion, std::abs(u));
  return 1e-24 * scene.energy() * motion * motion;
}

/// See Level::relativeEstimate.
double relative(const Scene& scene, const std::vector<const SolvedBodies*>& states,
                const bem::Vector& estimates, const bem::Vector& strainEnergies) {
  const double largest = *std::max_element(strainEnergies.begin(), strainEnergies.end());
  double result = 0;
  for (std::size_t k = 0; k < estimates.size(); ++k) {
    if (!std::isfinite(estimates[k]))
      return std::numeric_limits<double>::infinity();
    const double square = estimates[k] * estimates[k];
    // rounding may leave an energy below zero
    const double norm = 2 * std::max({strainEnergies[k], largest / 100, 0.0});
    if (std::max(square, norm) > roundingOf(scene, *states[k]))
      result = std::max(result, estimates[k] / std::sqrt(norm));
  }
  return result;
}

/// Estimates the error of some states on one mesh: the steps of a path, or one load.
///
/// Sets the level's indicators, of each element those of the state in which they are largest,
/// and its relative estimate.
/// \param strainEnergies of each state, in the user's units
/// \returns the error estimate of each state
bem::Vector estimateErrors(const Ground& ground,
                           const std::vector<const SolvedBodies*>& states,
                           const bem::Vector& strainEnergies, Level& level) {
  bem::Vector estimates(states.size(), 0.0);
  for (std::size_t b = 0; b < level.bodies.size(); ++b) {
    const std::vector<adaptivity::Indicators> all = indicatorsOf(ground, states, b);
    for (std::size_t k = 0; k < all.size(); ++k)
      estimates[k] = std::hypot(estimates[k], all[k].estimate());
    level.bodies[b].indicators = adaptivity::largest(all);
  }
  level.relativeEstimate =
      ground.processes
          .broadcast({relative(ground.scene, states, estimates, strainEnergies)})
          .front();
  return estimates;
}

/// The smallest gamma0 of a body with stabilised contact; zero if there is none.
double gamma0Of(const contact::ContactSystem& system) {
  double smallest = 0;
  for (std::size_t b = 0; b < system.size(); ++b) {
    const double own = system.body(b).gamma0();
    if (own > 0 && (smallest == 0 || own < smallest))
      smallest = own;
  }
  return smallest;
}

/// The row of history.csv, without what its caller knows: size, operators, note, report,
/// friction's work and the worst step.
LevelRow makeRow(const Ground& ground, const Level& level,
                 const contact::ContactSystem& system, const SolvedBodies& solved) {
  LevelRow row;
  row.level = level.number;
  row.gamma0 = gamma0Of(system);
  row.defect = solved.at().defect;
  row.bodies = contact::summarizeAll(solved.bodies());
  row.rigid = solved.rigidRows();
  row.summary = wholeOf(ground.scene.symmetry, contact::sumOf(row.bodies));
  row.bodies = wholeBodies(ground.scene, std::move(row.bodies));
  row.energyInterface = solved.interfaceEnergy();
  row.reason = level.reason;
  row.estimate = level.estimate();
  row.relativeEstimate = level.relativeEstimate;
  row.worstEstimate = row.estimate;
  row.squares = level.squares();
  return row;
}

/// CPU seconds of the level's phases, elapsed seconds and memory until now, the largest of
/// all processes.
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
    row.size = ground.spaces.totalSize();
    row.size.memory = begun.plan.memory;
    if (begun.plan.compressed)
      row.operators = "compressed";
    else if (begun.plan.insteadOfCompressed)
      row.operators = denseInstead;
    row.note = begun.plan.advice;
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
                  const LevelStart& from, const NewLevel& begun) {
  PhaseTimer& timer = begun.timer;
  const contact::State first = atZero.joined(from.start, from.rigid);
  const auto handOut = [&](const Path& sofar) {
    const bool another = begun.plan.denseInstead && !sofar.last().row.converged;
    if (begun.handOutStep && !another)
      timer.run(Phase::Results, [&] { handOutStep(ground, sofar, begun); });
  };
  const Path path = followPath(ground, atZero, first, from.path, timer, handOut);
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
  const auto stiffness = makeStiffness(scene, spaces, lames, begun.plan.compressed,
                                       krylov, processes, begun.timer);
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
  return scene.history ? solvePath(ground, system, from, begun)
                       : solveOnce(ground, system, first, from, begun);
}

}  // namespace epafi::drivers
