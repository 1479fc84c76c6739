#pragma once

#include "drivers/run/SolvedStep.hpp"

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

/// A level with the tables of its run as text: the content of solution.hdf, for a restart or
/// for the reference of a study.
struct Checkpoint {
  Level level{};
  std::string used{};     ///< used.xml
  std::string history{};  ///< history.csv up to the level
  std::string steps{};    ///< steps.csv up to the step; empty without a History
  std::string bodies{};   ///< bodies.csv up to the level; may be empty, see tellsBodies
  double secondsTotal = 0;
  double secondsWall = 0;

  /// Before the first level of a run, which may go on from an earlier one.
  static Checkpoint before(const Scene& scene,
                           const std::optional<Checkpoint>& earlier = {});
  void addStep(const SolvedStep& step);
  /// Call it after addStep for the steps of the level.
  void addLevel(const SolvedLevel& solved, const LevelRow& row);
  /// Takes the level, or a step of its path, and its times.
  void take(const SolvedLevel& solved, const LevelRow& row);
};

}  // namespace epafi::drivers
