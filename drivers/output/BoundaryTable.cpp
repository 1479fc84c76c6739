#include "drivers/output/BoundaryTable.hpp"

#include "drivers/output/BoundaryLines.hpp"
#include "drivers/output/Csv.hpp"

namespace epafi::drivers {

std::string boundaryCsv(const Scene& scene, const SolvedLevel& level) {
  Csv csv({"x", "y", "ux", "uy", "tx", "ty", "boundary", "element", "degree", "body"});
  for (std::size_t b = 0; b < level.bodies.size(); ++b) {
    const contact::Solved& solved = level.bodies[b];
    const bem::Vector& density = level.level.bodies[b].density;
    const bem::Mesh& mesh = solved.space.mesh();
    for (int e = 0; e < mesh.size(); ++e) {
      const int intervals = linesOf(mesh[e]);
      for (int k = 0; k <= intervals; ++k) {
        const double t = -1 + 2.0 * k / intervals;
        const bem::Vec2 x = mesh.physicalPoint(e, t);
        const bem::Vec2 u =
            solved.units.length * solved.space.displacementAt(solved.displacement, e, t);
        const bem::Vec2 traction =
            solved.units.stress * solved.space.densityAt(density, e, t);
        csv.row({exactly(x.x), exactly(x.y), exactly(u.x), exactly(u.y),
                 exactly(traction.x), exactly(traction.y),
                 scene.boundaryName(b, mesh.boundary(e)), std::to_string(e),
                 std::to_string(mesh[e].degree), scene.bodies[b].name});
      }
    }
  }
  return csv.text();
}

}  // namespace epafi::drivers
