#pragma once

#include "drivers/output/BoundaryLines.hpp"
#include "drivers/scene/Scene.hpp"

#include <string>

namespace epafi::drivers {

/// A level with the tables of its run: the content of solution.hdf, for a restart or for
/// the reference of a study.
struct Checkpoint {
  Level level;
  std::string used;      ///< used.xml
  std::string history;   ///< history.csv up to the level
  std::string steps;     ///< steps.csv up to the step; empty without a History
  std::string bodies{};  ///< bodies.csv up to the level; may be empty, see tellsBodies
  double secondsTotal = 0;
  double secondsWall = 0;
};

/// solution.hdf: a level for plots and for a restart.              [doc/solution-file.md]
///
///   /VTKHDF  segments of the boundary with the fields, which ParaView can open
///   /Epafi   all numbers of the level and the tables of its run, with a checksum
///
/// Returns the bytes.  Every process holds all of the arguments: not collective.
std::string solutionFile(const Scene& scene, const Checkpoint& checkpoint,
                         const BoundaryLines& grid);

/// \throws bem::InputError with the name of the file, if it is missing, incomplete,
///   damaged, or of another format.
Checkpoint readSolution(const std::string& path);

}  // namespace epafi::drivers
