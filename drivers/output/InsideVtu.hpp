#pragma once

#include "drivers/output/Inside.hpp"

#include <array>
#include <string>
#include <vector>

namespace epafi::drivers {

/// All bodies as triangles with the values at their corners.  At a node of the boundary
/// the value is the mean over the two elements that meet there.
struct FilledBodies {
  std::vector<InsidePoint> points;
  std::vector<InsideValue> values;          ///< of each point
  std::vector<std::array<int, 3>> corners;  ///< of each triangle, counter-clockwise
};
FilledBodies fill(const BodyInsides& insides);

/// A file for ParaView (.vtu, UnstructuredGrid): the triangles with displacement, the
/// scalar fields of fieldNames() and the number of the body.
std::string vtuFile(const FilledBodies& bodies);

/// The names of the scalar fields of such a file.
std::vector<std::string> fieldNames();

}  // namespace epafi::drivers
