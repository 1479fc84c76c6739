#include "drivers/run/LevelRow.hpp"

#include "drivers/process/Ranks.hpp"
#include "drivers/process/Resources.hpp"
#include "drivers/run/Whole.hpp"

#include <algorithm>

namespace epafi::drivers {

namespace {

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

}  // namespace

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

}  // namespace epafi::drivers
