#pragma once

#include "drivers/output/HistoryTables.hpp"
#include "drivers/output/VtkGrid.hpp"

#include <string>

namespace epafi::drivers {

/// solution.hdf: a level for plots and for a restart.              [doc/solution-file.md]
///
///   /VTKHDF  segments of the boundary with the fields, which ParaView can open
///   /Epafi   all numbers of the level and the tables of its run, with a checksum
///
/// Returns the bytes; `grid`: see boundaryLines.  Every process holds all of the arguments: not collective.
std::string solutionFile(const Scene& scene, const Checkpoint& checkpoint,
                         const VtkGrid& grid);

/// \throws bem::InputError with the name of the file, if it is missing, incomplete,
///   damaged, or of another format.
Checkpoint readSolution(const std::string& path);

}  // namespace epafi::drivers
