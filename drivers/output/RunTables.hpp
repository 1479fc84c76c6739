#pragma once

#include "drivers/output/SolutionFile.hpp"
#include "drivers/run/Path.hpp"

#include <optional>
#include <string>
#include <vector>

namespace epafi::drivers {

/// history.csv, a row per level: its columns, and a row in their order.
std::vector<std::string> historyColumns();
std::vector<std::string> historyCells(const LevelRow& row);
std::string historyHead();
/// Where a column stands.  \pre there is one of this name
std::size_t historyColumn(const std::string& name);

/// The cells of the last line of a history.csv of this version.
std::vector<std::string> lastCells(const std::string& history);
/// The number in a column, as such cells have it.
double valueOf(const std::vector<std::string>& cells, const std::string& name);
/// strain and surface energy - fᵀ u + friction's work as such cells have it [stress length²].
double energyOf(const std::vector<std::string>& cells);

/// steps.csv, a row per level and step: columns of its own, of each contact and of each body
/// without elasticity.
std::string stepsHead(const StepRow& row);
/// Friction's work up to each step of a level, as steps.csv has it; nothing of an empty text.
std::vector<double> dissipatedOf(const std::string& steps, int level);

/// bodies.csv, a row per level, step of a path (else 0) and body: the resultants of loads,
/// contact and what holds it, which add up to nothing, and its motion: of a body that deforms
/// the mean over its boundary, of another one that of its reference point.
std::string bodiesHead();

/// The tables of a run's levels so far, as they stand in its files.
struct RunTables {
  /// `earlier`: what the run goes on from.
  explicit RunTables(const Scene& scene, const std::optional<Checkpoint>& earlier = {});

  void addStep(const StepRow& row);
  /// Behind its steps.
  void addLevel(const SolvedLevel& level, const LevelRow& row);

  /// solution.hdf of a level whose row this is.
  std::string solution(const Level& level, const LevelRow& row,
                       const BoundaryLines& grid) const;

  const Scene& scene;
  std::string used;
  std::string history;
  std::string steps;   ///< empty without a History
  std::string bodies;  ///< empty where there is nothing to tell of bodies
};

}  // namespace epafi::drivers
