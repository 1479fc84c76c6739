#pragma once

#include "drivers/output/Inside.hpp"
#include "drivers/output/Triangulation.hpp"

namespace epafi::drivers {

/// All bodies as triangles with the values at their points, up to the boundary: there the
/// mean of what the elements say that meet at the point.
struct FilledBodies {
  Triangulation triangles;
  std::vector<InsideValue> values;  ///< of each point
  std::vector<int> body;            ///< of each point
};
FilledBodies fill(const BodyInsides& insides);

/// A VTK file (.vtu, UnstructuredGrid as text) that ParaView opens: the triangles with
/// displacement, the stresses by the names of fields.csv, and the body's number.
std::string vtuFile(const FilledBodies& bodies);

/// The names of the scalar fields of a file.
std::vector<std::string> fieldNames();

}  // namespace epafi::drivers
