#pragma once

#include "drivers/output/BoundaryLines.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

class Hdf5Writer;

/// An UnstructuredGrid of VTK's XML: the data arrays of each of its parts as texts.
struct VtuGrid {
  std::size_t points;
  std::size_t cells;
  std::string shown;  ///< the arrays that ParaView begins with
  std::vector<std::string> pointData{};
  std::vector<std::string> cellData{};
  std::vector<std::string> places{};
  std::vector<std::string> topology{};
};
std::string vtuText(const VtuGrid& grid);
/// A data array of it, in base64.  For T = double, int, long long, unsigned char.
template <class T>
std::string dataArray(const char* name, const std::vector<T>& values, int components = 1);

/// steps/<k>/boundary.vtu: the boundaries of all bodies at a step with the fields of
/// solution.hdf, as an UnstructuredGrid of VTK's XML (binary, Base64).
std::string boundaryVtu(const BoundaryLines& grid);

/// The files of a name of the steps at their times, one collection that ParaView opens:
/// steps.pvd of boundary.vtu, fields.pvd of fields.vtu.
std::string stepsPvd(const std::vector<double>& times, const std::string& name);

/// "steps/<k>/<name>", k = 1, 2, ...
std::string stepFile(std::size_t step, const std::string& name);

/// Writes the boundary as lines with the fields on them into the group /VTKHDF, which ParaView
/// opens.
void writeVtkHdf(const BoundaryLines& grid, Hdf5Writer& writer);

}  // namespace epafi::drivers
