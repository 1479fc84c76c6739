#include "drivers/output/VtkHdf.hpp"

namespace epafi::drivers {

void writeVtkHdf(const BoundaryLines& grid, Hdf5Writer& writer) {
  constexpr unsigned char vtkLine = 3;
  writer.attribute("/VTKHDF", "Version", std::vector<int>{1, 0});
  writer.attribute("/VTKHDF", "Type", "UnstructuredGrid");
  const auto write = [&](const char* name, const auto& array, long long columns = 1) {
    writer.array(std::string("/VTKHDF/") + name, array, columns);
  };
  const auto count = [](const auto& array) {
    return std::vector<long long>{static_cast<long long>(array.size())};
  };
  write("NumberOfPoints", count(grid.pressure));
  write("NumberOfCells", count(grid.element));
  write("NumberOfConnectivityIds", count(grid.ends));
  write("Points", grid.points, 3);
  write("Connectivity", grid.ends);
  std::vector<long long> offsets(grid.element.size() + 1);
  for (std::size_t line = 0; line < offsets.size(); ++line)
    offsets[line] = static_cast<long long>(2 * line);
  write("Offsets", offsets);
  write("Types", std::vector<unsigned char>(grid.element.size(), vtkLine));

  write("PointData/displacement", grid.displacement, 3);
  write("PointData/traction", grid.traction, 3);
  write("PointData/lambda_n", grid.pressure);
  write("PointData/lambda_t", grid.shear);
  write("PointData/gap", grid.gap);
  write("PointData/contact", grid.contact);
  write("PointData/friction", grid.friction);
  write("CellData/element", grid.element);
  write("CellData/degree", grid.degree);
  write("CellData/boundary", grid.boundary);
  write("CellData/body", grid.body);
}

}  // namespace epafi::drivers
