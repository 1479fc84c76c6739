#pragma once

#include "drivers/output/Inside.hpp"

#include <array>
#include <string>
#include <vector>

namespace epafi::drivers {

/// All bodies as triangles with the values at their points, up to the boundary: there the
/// mean of what the elements say that meet at the point.
struct FilledBodies {
  std::vector<InsidePoint> points;
  std::vector<InsideValue> values;          ///< of each point
  std::vector<std::array<int, 3>> corners;  ///< of each triangle, counter-clockwise
};
FilledBodies fill(const BodyInsides& insides);

/// A VTK file (.vtu, UnstructuredGrid) that ParaView opens: the triangles with
/// displacement, the stresses by the names of fields.csv, and the body's number.
std::string vtuFile(const FilledBodies& bodies);

/// The names of the scalar fields of a file.
std::vector<std::string> fieldNames();

}  // namespace epafi::drivers
