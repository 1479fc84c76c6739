#pragma once

#include <string>
#include <variant>
#include <vector>

namespace epafi::drivers {

class Hdf5Writer;

/// A field of a grid, point by point or cell by cell.  Refers to the numbers.
struct VtkArray {
  std::string name;
  std::variant<const std::vector<double>*, const std::vector<int>*> numbers;
  int components = 1;
};

/// Segments or triangles with fields for ParaView, in the user's units: an UnstructuredGrid.
struct VtkGrid {
  const std::vector<double>& points;      ///< x, y, 0
  const std::vector<long long>& corners;  ///< indices of the points of each cell
  int cornersPerCell;                     ///< 2: segments, 3: triangles
  std::string shown;  ///< attributes of PointData: the arrays that ParaView shows first
  std::vector<VtkArray> pointData;
  std::vector<VtkArray> cellData{};
};

/// The grid in VTK's XML format (.vtu), arrays in Base64.
std::string vtuText(const VtkGrid& grid);

/// Writes the grid into the group /VTKHDF, which ParaView can open.
void writeVtkHdf(const VtkGrid& grid, Hdf5Writer& writer);

/// A ParaView collection of the files `name` of all steps with their times: steps.pvd for
/// boundary.vtu, fields.pvd for fields.vtu.
std::string stepsPvd(const std::vector<double>& times, const std::string& name);

/// "steps/<k>/<name>", k = 1, 2, ...
std::string stepFile(std::size_t step, const std::string& name);

}  // namespace epafi::drivers
