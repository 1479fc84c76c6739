#pragma once

#include "drivers/output/Table.hpp"
#include "drivers/run/SolvedStep.hpp"

#include <optional>
#include <string>
#include <vector>

namespace epafi::drivers {

/// A row of history.csv, a row per level.
Cells cellsOf(const LevelRow& row);
/// Strain and surface energy - fᵀ u + work of friction, in such a row [stress length²].
double energyOf(const Table& history, std::size_t row);

/// A row of steps.csv, a row per level and step: columns of the step, of each contact and of
/// each rigid body.
Cells cellsOf(const StepRow& row);
/// Work of friction up to each step of a level, from steps.csv; empty without rows.
std::vector<double> dissipatedOf(const Table& steps, int level);

/// A row of bodies.csv, a row per level, step (0 without a path) and body: resultants of loads, body
/// loads, contact forces and reactions, which sum to zero, and the motion: of an elastic body the mean
/// over its boundary, of a rigid one that of its reference point.
Cells cellsOf(const StepRow& step, const std::string& body, const contact::Summary& s);

/// The columns of history.csv and of steps.csv, which name the scene's contacts, and of bodies.csv.
Table historyTable(const Scene& scene);
Table stepsTable(const BodySpaces& spaces);
Table bodiesTable();

/// A level with the tables of its run: the content of solution.hdf, for a restart or
/// for the reference of a study.
struct Checkpoint {
  Level level{};
  std::string used{};  ///< used.xml
  Table history{};     ///< history.csv up to the level
  Table steps{};       ///< steps.csv up to the step; without columns without a History
  Table
      bodies{};  ///< bodies.csv up to the level; may be without columns, see tellsBodies
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
