#pragma once

#include "bem/base/Vec2.hpp"

#include <string>
#include <variant>
#include <vector>

namespace epafi::drivers {

class Hdf5Writer;

/// Numbers with a name, row by row: a field of a grid, by point or by cell.
struct DataArray {
  std::string name;
  std::variant<std::vector<double>, std::vector<int>> numbers;
  int columns = 1;

  void add(int value) { std::get<std::vector<int>>(numbers).push_back(value); }
  void add(double value) { std::get<std::vector<double>>(numbers).push_back(value); }
  void add(bem::Vec2 vector);  ///< of three components
  template <class Number>
  Number at(std::size_t k) const {
    return std::get<std::vector<Number>>(numbers)[k];
  }
  std::size_t size() const;  ///< of all rows
};
/// Writes an array into a group.
void write(const std::string& group, const DataArray& array, Hdf5Writer& writer);

/// Segments or triangles with fields for ParaView, in the user's units: an UnstructuredGrid.
struct VtkGrid {
  int cornersPerCell;  ///< 2: segments, 3: triangles
  std::string shown;   ///< attributes of PointData: the arrays that ParaView shows first
  std::vector<DataArray> pointData;
  std::vector<DataArray> cellData{};
  DataArray points{"Points", std::vector<double>(), 3};  ///< x, y, 0
  std::vector<long long> corners{};                      ///< indices of points, by cell

  std::size_t size() const;  ///< number of points
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
