#pragma once

#include "drivers/output/SolutionFile.hpp"
#include "drivers/run/Path.hpp"

#include <optional>
#include <string>
#include <vector>

namespace epafi::drivers {

/// history.csv, a row per level: names of columns, cells of a row, first line.
std::vector<std::string> historyColumns();
std::vector<std::string> historyCells(const LevelRow& row);
std::string historyHead();
/// Index of a column.  \pre a column has this name
std::size_t historyColumn(const std::string& name);

/// Cells of the last line of a history.csv that this version has written.
std::vector<std::string> lastCells(const std::string& history);
/// The number in a column of such cells.
double valueOf(const std::vector<std::string>& cells, const std::string& name);
/// Strain and surface energy - fᵀ u + work of friction, from such cells [stress length²].
double energyOf(const std::vector<std::string>& cells);

/// First line of steps.csv, a row per level and step: columns of the step, of each
/// contact and of each rigid body.
std::string stepsHead(const StepRow& row);
/// Work of friction up to each step of a level, from steps.csv; empty for an empty text.
std::vector<double> dissipatedOf(const std::string& steps, int level);

/// bodies.csv, a row per level, step (0 without a path) and body: resultants of loads,
/// body loads, contact forces and reactions, which sum to zero, and the motion: of an
/// elastic body the mean over its boundary, of a rigid one that of its reference point.
std::string bodiesHead();

/// The tables of a run up to now, as text.
struct HistoryTables {
  /// `earlier`: the checkpoint that the run continues.
  explicit HistoryTables(const Scene& scene,
                         const std::optional<Checkpoint>& earlier = {});

  void addStep(const StepRow& row);
  /// Call it after addStep for the steps of the level.
  void addLevel(const SolvedLevel& level, const LevelRow& row);

  /// The bytes of solution.hdf for a level with this row of history.csv.
  std::string solution(const Level& level, const LevelRow& row,
                       const BoundaryLines& grid) const;

  const Scene& scene;
  std::string used;
  std::string history;
  std::string steps;   ///< empty without a History
  std::string bodies;  ///< empty unless Scene::tellsBodies
};

}  // namespace epafi::drivers
