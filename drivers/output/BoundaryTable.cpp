#include "drivers/output/BoundaryTable.hpp"

#include "drivers/output/Csv.hpp"

namespace epafi::drivers {

std::string boundaryCsv(const Scene& scene, const BoundaryLines& grid) {
  Csv csv({"x", "y", "ux", "uy", "tx", "ty", "boundary", "element", "degree", "body"});
  const std::vector<std::string> names = namesOfBoundaries(scene);
  const auto addPoint = [&](std::size_t line, long long point) {
    std::vector<std::string> cells;
    for (const auto* field : {&grid.points, &grid.displacement, &grid.traction})
      for (const long long component : {0, 1})
        cells.push_back(
            exactly((*field)[static_cast<std::size_t>(3 * point + component)]));
    cells.push_back(names[static_cast<std::size_t>(grid.boundary[line])]);
    cells.push_back(std::to_string(grid.element[line]));
    cells.push_back(std::to_string(grid.degree[line]));
    cells.push_back(scene.bodies[static_cast<std::size_t>(grid.body[line])].name);
    csv.row(cells);
  };
  const std::size_t lines = grid.element.size();
  const auto deforms = [&](std::size_t line) {
    return line < lines && grid.body[line] < static_cast<int>(scene.bodies.size());
  };
  for (std::size_t line = 0; deforms(line); ++line) {
    addPoint(line, grid.ends[2 * line]);
    const bool endsElement =
        !deforms(line + 1) || grid.ends[2 * line + 2] != grid.ends[2 * line + 1];
    if (endsElement)
      addPoint(line, grid.ends[2 * line + 1]);
  }
  return csv.text();
}

}  // namespace epafi::drivers
