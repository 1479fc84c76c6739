#pragma once

#include "drivers/output/BoundaryLines.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

class Hdf5Writer;

/// An UnstructuredGrid in VTK's XML format: for each section, its data arrays as text.
struct VtuGrid {
  std::size_t points;
  std::size_t cells;
  std::string shown;  ///< attributes of PointData: the arrays that ParaView shows first
  std::vector<std::string> pointData{};
  std::vector<std::string> cellData{};
  std::vector<std::string> places{};
  std::vector<std::string> topology{};
};
std::string vtuText(const VtuGrid& grid);
/// A data array of such a grid, in Base64.  T: double, int, long long, unsigned char.
template <class T>
std::string dataArray(const char* name, const std::vector<T>& values, int components = 1);

/// steps/<k>/boundary.vtu: the boundaries of all bodies at a step with the fields of
/// solution.hdf, as an UnstructuredGrid in VTK's XML format (Base64).
std::string boundaryVtu(const BoundaryLines& grid);

/// A ParaView collection of the files `name` of all steps with their times: steps.pvd for
/// boundary.vtu, fields.pvd for fields.vtu.
std::string stepsPvd(const std::vector<double>& times, const std::string& name);

/// "steps/<k>/<name>", k = 1, 2, ...
std::string stepFile(std::size_t step, const std::string& name);

/// Writes the segments with their fields into the group /VTKHDF, which ParaView can open.
void writeVtkHdf(const BoundaryLines& grid, Hdf5Writer& writer);

}  // namespace epafi::drivers
