#pragma once

#include "drivers/output/BoundaryLines.hpp"
#include "drivers/output/SolutionArrays.hpp"
#include "drivers/scene/Scene.hpp"

#include <string>

namespace epafi::drivers {

/// A level with what stands around it in its run: what solution.hdf keeps for a run that
/// goes on later, and a study for a reference.
struct Checkpoint {
  Level level;
  std::string used;      ///< used.xml
  std::string history;   ///< history.csv up to the level
  std::string steps;     ///< steps.csv up to the step; empty without a History
  std::string bodies{};  ///< bodies.csv up to the level; empty of one body
  double secondsTotal = 0;
  double secondsWall = 0;
};

/// solution.hdf: a level to look at and to go on from.             [doc/solution-file.md]
///
///   /VTKHDF  the boundary as lines with the fields on them, which ParaView opens
///   /Epafi   all numbers that the next level is made from, with a checksum
///
/// Its bytes, from what every process has whole: a checkpoint and its boundaryLines.
std::string solutionFile(const Scene& scene, const Checkpoint& checkpoint,
                         const BoundaryLines& grid);

/// \throws bem::InputError naming the file, if it is not there, not complete, damaged, or
///   of a format that this version does not know.
Checkpoint readSolution(const std::string& path);

}  // namespace epafi::drivers
