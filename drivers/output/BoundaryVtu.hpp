#pragma once

#include "drivers/output/BoundaryLines.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// steps/<k>/boundary.vtu: the boundaries of all bodies at a step with the fields of
/// solution.hdf, as an UnstructuredGrid of VTK's XML (binary, Base64).
std::string boundaryVtu(const BoundaryLines& grid);

/// steps.pvd: the files of the steps at their times, one collection that ParaView opens.
std::string stepsPvd(const std::vector<double>& times);

/// "steps/<k>/<name>", k = 1, 2, ...
std::string stepFile(std::size_t step, const std::string& name);

}  // namespace epafi::drivers
