#include "drivers/run/SolveLevel.hpp"

#include "adaptivity/estimate/ResidualEstimator.hpp"
#include "bem/base/Error.hpp"
#include "contact/compressed/CompressedStiffness.hpp"
#include "drivers/process/Ranks.hpp"
#include "drivers/run/ContactEstimate.hpp"
#include "drivers/run/FrictionLimit.hpp"
#include "drivers/run/LevelPlan.hpp"
#include "drivers/run/Path.hpp"
#include "drivers/run/UnheldMotions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::drivers {

namespace {

/// The Steklov-Poincaré operators of all bodies, factored, as dense matrices or compressed.
/// \throws bem::NumericalError if a factorisation breaks down
std::vector<bem::SteklovPoincare> makeStiffness(const BodySpaces& spaces,
                                                const std::vector<bem::Lame>& lames,
                                                bool compressed, const Run& run) {
  const Scene& scene = spaces.scene();
  if (compressed)
    return run.timer.run(Phase::Factorization, [&] {
      return contact::makeCompressedStiffness(
          spaces.all(), lames, spaces.multiplier(), *spaces.opposite(),
          scene.stabilization, scene.units(), run.processes,
          scene.solver.linear.compression, formedUpTo(scene.history.times.size()));
    });
  std::vector<bem::SteklovPoincare> all;
  for (std::size_t b = 0; b < spaces.size(); ++b) {
    const bem::Space& space = spaces.space(b);
    bem::Operators operators = run.timer.run(
        Phase::Assembly, [&] { return bem::assembleOperators(space, lames[b]); });
    run.timer.run(Phase::Factorization, [&] {
      const bem::LocalCompliance compliance =
          contact::densityCompliance(space, scene.bodies[b].conditions,
                                     scene.stabilization, lames[b], scene.units());
      if (run.krylov != nullptr)
        all.emplace_back(std::move(operators), *run.krylov, compliance);
      else
        all.emplace_back(std::move(operators), compliance);
    });
  }
  return all;
}

/// See Level::relativeEstimate.
double relative(const SolvedLevel& solved, const bem::Vector& estimates) {
  // a strain of this part of the thermal one has no meaning in a body that heat leaves unstrained
  constexpr double negligible = 1e-12;  // of squared norms
  // where nothing is loaded, sides that touch overlap by rounding
  const double overlap = 1e-24 * solved.last().spaces.scene().energy();
  double largest = solved.steps.front()->row.energyStrain;
  for (const auto& step : solved.steps)
    largest = std::max(largest, step->row.energyStrain);
  double result = 0;
  for (std::size_t k = 0; k < estimates.size(); ++k) {
    if (!std::isfinite(estimates[k]))
      return std::numeric_limits<double>::infinity();
    const SolvedStep& step = *solved.steps[k];
    const SolvedStep::Storable storable = step.storable();
    const double square = estimates[k] * estimates[k];
    // rounding may leave an energy below zero
    const double norm = 2 * std::max({step.row.energyStrain, largest / 100, 0.0});
    if (std::max(square, norm) > std::max(storable.rounding, norm > 0 ? 0 : overlap))
      result = std::max(
          result, estimates[k] / std::sqrt(std::max(norm, negligible * storable.inside)));
  }
  return result;
}

/// Estimates the error of all steps; of a half cut by symmetry as of the whole.
///
/// Sets the level's indicators, of each element those of the step in which they are largest,
/// and its relative estimate.
/// \returns the error estimate of each step
bem::Vector estimateErrors(const bem::Processes& processes, SolvedLevel& solved) {
  const Scene& scene = solved.last().spaces.scene();
  bem::Vector estimates(solved.steps.size(), 0.0);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    std::vector<adaptivity::Estimated> ofBody;
    ofBody.reserve(solved.steps.size());
    for (const auto& step : solved.steps)
      ofBody.push_back({step->bodies[b], step->densities[b]});
    std::vector<adaptivity::Indicators> all = adaptivity::estimateResiduals(
        ofBody, scene.lame(b), scene.adaptivity.estimator, processes);
    for (std::size_t k = 0; k < all.size(); ++k) {
      for (adaptivity::Contributions& squares : all[k].squares)
        for (double& square : squares)
          square *= scene.symmetry.copies();
      estimates[k] = std::hypot(estimates[k], all[k].estimate());
    }
    solved.level.indicators.push_back(adaptivity::largest(all));
  }
  solved.level.relativeEstimate =
      processes.broadcast({relative(solved, estimates)}).front();
  return estimates;
}

/// See Level::energies.
bem::Vector energiesOf(const SolvedLevel& solved) {
  const double copies = solved.last().spaces.scene().symmetry.copies();
  bem::Vector energies(solved.last().bodies.size(), 0.0);
  for (const auto& step : solved.steps)
    for (std::size_t b = 0; b < energies.size(); ++b)
      energies[b] = std::max({energies[b], copies * step->summaries()[b].energyStrain,
                              step->storable().rounding});
  return energies;
}

/// The smallest gamma0 of a body with stabilised contact; zero if there is none.
double gamma0Of(const contact::ContactSystem& system) {
  double smallest = 0;
  for (std::size_t b = 0; b < system.size(); ++b) {
    const double own = system.body(b).coupling().gamma0;
    if (own > 0 && (smallest == 0 || own < smallest))
      smallest = own;
  }
  return smallest;
}

/// CPU seconds of the level's phases, elapsed seconds and memory until now, the largest of
/// all processes.
void addTimes(const Run& run, LevelRow& row) {
  const auto& phases = run.timer.levelSeconds();
  bem::Vector cost(phases.begin(), phases.end());
  cost.insert(cost.end(), {cpuSeconds(), run.timer.wallSeconds(), peakMemory()});
  cost = largestOverRanks(run.processes, cost);
  std::copy_n(cost.begin(), phaseCount, row.seconds.begin());
  row.secondsTotal = cost[phaseCount];
  row.secondsWall = cost[phaseCount + 1];
  row.memory = cost[phaseCount + 2];
}

/// Adds the results of the last step to the row, `estimates` of all steps.
void addResults(const bem::Vector& estimates, SolvedLevel& solved) {
  const SolvedStep& last = solved.last();
  const Level& level = solved.level;
  LevelRow& row = solved.row;
  row.level = level.number;
  row.gamma0 = gamma0Of(*last.system);
  row.contacts = last.row.contacts;
  row.summary = wholeOf(last.spaces.scene().symmetry, contact::sumOf(last.summaries()));
  row.energyFriction = last.row.energyDissipated;
  row.energyInterface = last.row.energyInterface;
  row.estimate = level.estimate();
  row.relativeEstimate = level.relativeEstimate;
  for (const ContactEstimate& contact : level.contacts)
    row.contactEstimate = std::max(row.contactEstimate, contact.relative);
  row.squares = level.squares();
  row.worstEstimate = row.estimate;
  if (level.onPath()) {
    const auto worst = std::max_element(estimates.begin(), estimates.end());
    row.worstStep = 1 + static_cast<int>(worst - estimates.begin());
    row.worstEstimate = *worst;
  }
}

/// See Level::doubts.
bem::Vector doubtsOf(const SolvedLevel& solved) {
  bem::Vector doubts(solved.last().row.contacts.size(), 0.0);
  for (std::size_t k = 0; k < doubts.size(); ++k) {
    double largest = 0;
    for (const auto& step : solved.steps)
      if (const contact::PeakPressure& peak = step->row.contacts[k].second.peak;
          peak.value() > largest) {
        largest = peak.value();
        doubts[k] = peak.isUnbounded() ? 0 : peak.error() / peak.value();
      }
  }
  return doubts;
}

/// Estimates the error of what is solved and hands out the level.
Level finish(const Run& run, SolvedLevel solved) {
  solved.last().system->numbers().flexibility.release();  // estimates take as much
  Level& level = solved.level;
  level.complete = true;
  level.status = solved.row.report.status;
  level.steps.clear();
  for (const auto& step : solved.steps)
    level.steps.push_back(step->fields());
  level.indicators.clear();
  const bem::Vector estimates = run.timer.run(
      Phase::Estimate, [&] { return estimateErrors(run.processes, solved); });
  level.energies = energiesOf(solved);
  level.doubts = doubtsOf(solved);
  if (solved.last().spaces.scene().adaptivity.estimator.weights == "Energy")
    level.contacts = contactEstimates(solved.last().spaces, level, run.processes);
  run.timer.run(Phase::Results, [&] {
    addResults(estimates, solved);
    addTimes(run, solved.row);
    run.handOut(solved);
  });
  return std::move(level);
}

/// Hands out the last step of a path that is not at its end.
void handOutStep(const Run& run, SolvedLevel& path) {
  Level& level = path.level;
  level.complete = false;
  level.status = path.row.report.status;
  level.steps = {path.last().fields()};
  level.indicators.resize(level.meshes.size());
  for (std::size_t b = 0; b < level.meshes.size(); ++b)
    level.indicators[b].squares.resize(level.meshes[b].size());
  addTimes(run, path.row);
  run.handOutStep(path);
}

/// What the solver says of a level that is not converged, with the step of a path that it ends in.
std::string reasonAtEnd(const SolvedLevel& level) {
  return level.ends + (level.ends.empty() ? "" : ": ") + level.level.reason;
}

/// Did the path of offsets find no state to go on to?  Not where its steps or its size were limited.
bool findsNoState(const contact::Report& report) {
  if (report.stages.empty())
    return false;
  const contact::StageRun& last = report.stages.back();
  using contact::End;
  return last.stage == contact::Stage::FollowOffset && last.end != End::Iterations &&
         last.end != End::TooLong && last.end != End::TooLarge &&
         last.end != End::NotFinite;
}

/// Why a level is not converged, with the step of a path that it ends in.  Where all of a contact slips and
/// no state was found, friction's limit comes in place of the solver's advice.
std::string reasonOf(const SolvedLevel& level) {
  const std::string limits = frictionLimits(level.last());
  const std::string doubt =
      limits.empty() || level.level.number > 0 ||
              !level.last().spaces.scene().adaptivity.limits.tolerance
          ? ""
          : ".  What friction holds is that of the first mesh, not refined yet: a "
            "smaller "
            "Discretization->Mesh Size tells how exact it is";
  if (!limits.empty() && findsNoState(level.row.report))
    return bem::message(
        limits, "The load may drive it beyond",
        level.ends.empty() ? "" : " (" + level.ends + ")",
        ": lessen the load, press harder, raise the friction, or hold the "
        "motion (Rigid Motions->Fix); tried last: ",
        contact::told({level.row.report.stages.back()}), doubt);
  return limits + reasonAtEnd(level) + doubt;
}

}  // namespace

Attempt solveLevel(const BodySpaces& spaces, const Level& from, const LevelRow& planned,
                   const Run& run) {
  const Scene& scene = spaces.scene();
  std::vector<bem::Lame> lames;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    lames.push_back(scene.lame(b));
  const contact::MultiplierBasis& basis = contact::multiplierBasis(scene.multiplier);
  const auto stiffness = makeStiffness(spaces, lames, planned.isCompressed(), run);
  const double time = scene.history.start();
  PathStart start{
      std::make_shared<const SolvedStep::Conditions>(spaces.conditionsAt(time)), {}};
  run.timer.run(Phase::Stabilization, [&] {
    std::vector<contact::BodyInput> inputs;
    for (std::size_t b = 0; b < spaces.size(); ++b)
      inputs.push_back({spaces.space(b), stiffness[b], lames[b], scene.units(),
                        (*start.conditions)[b], basis, scene.stabilization,
                        formedUpTo(scene.history.times.size())});
    start.system = std::make_shared<contact::ContactSystem>(inputs, scene.drivesAt(time),
                                                            spaces.opposite());
  });
  checkResistance(spaces, *start.system);
  SolvedLevel solved{stiffness, {from.number}, planned};
  solved.level.meshes = from.meshes;
  followPath(
      spaces, start, from, run,
      [&] {
        const bool another = solved.row.memoryOfDense && !solved.last().row.converged;
        if (scene.history && run.handOutStep && !another)
          run.timer.run(Phase::Results, [&] { handOutStep(run, solved); });
      },
      solved);
  if (planned.memoryOfDense && !solved.row.report.converged())
    return reasonAtEnd(solved);
  if (!solved.row.report.converged())
    solved.level.reason = reasonOf(solved);
  const std::string unbalanced = solved.unbalanced;
  Level level = finish(run, std::move(solved));
  if (!unbalanced.empty())
    throw bem::NumericalError(unbalanced);
  return level;
}

}  // namespace epafi::drivers
