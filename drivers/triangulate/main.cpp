/// Cuts the inside of a polygon with holes into triangles.
///
///   triangulate IN OUT
///
///   IN    largest edge; number of closed lines; of each the number of points, then x y;
///         the first is the outer one
///   OUT   numbers of points and triangles; x y and 1 on the boundary, 0 inside; the corners
///
/// Delaunay refinement by CGAL: angles of 20 degrees and more, as far as the polygon's own
/// allow, so triangles grow with the distance from short sides.  A program of its own, since
/// this part of CGAL is under the GNU General Public License (doc/decisions/0035).

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <list>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Faces = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<Vertices, Faces>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
using Point = Triangulation::Point;

/// sin²(20.7°), the largest for which refinement is known to end.
constexpr double shape = 0.125;

/// A point inside a hole: beside its longest side.  Holes run clockwise, the body is on the
/// left.
Point inside(const std::vector<Point>& hole) {
  std::size_t best = 0;
  const auto square = [&](std::size_t i) {
    return CGAL::to_double(CGAL::squared_distance(hole[i], hole[(i + 1) % hole.size()]));
  };
  for (std::size_t i = 1; i < hole.size(); ++i)
    if (square(i) > square(best))
      best = i;
  const Point a = hole[best];
  const Point b = hole[(best + 1) % hole.size()];
  const auto right = (b - a).perpendicular(CGAL::CLOCKWISE);
  return CGAL::midpoint(a, b) + 1e-6 * right;
}

/// The lines of `from` into triangles, a point of each hole into `holes`; false if there is none.
bool read(std::istream& from, std::size_t lines, Triangulation& triangles,
          std::list<Point>& holes) {
  std::vector<Point> points;
  std::vector<std::pair<std::size_t, std::size_t>> sides;
  for (std::size_t l = 0; l < lines; ++l) {
    std::size_t size = 0;
    from >> size;
    std::vector<Point> line;
    for (std::size_t i = 0; i < size; ++i) {
      double x = 0;
      double y = 0;
      from >> x >> y;
      line.emplace_back(x, y);
    }
    if (!from || size < 3)
      return false;
    for (std::size_t i = 0; i < size; ++i)
      sides.emplace_back(points.size() + i, points.size() + (i + 1) % size);
    points.insert(points.end(), line.begin(), line.end());
    if (l > 0)
      holes.push_back(inside(line));
  }
  // All points first, in an order of CGAL's: one after the other along a side, each flips the
  // triangles of all before it.
  triangles.insert_constraints(points.begin(), points.end(), sides.begin(), sides.end());
  return true;
}

using Face = Triangulation::Face_handle;
using Vertex = Triangulation::Vertex_handle;

/// The corners of these triangles, each once, in the order of their numbers.
std::vector<Vertex> numbered(const Triangulation& triangles,
                             const std::vector<Face>& faces) {
  for (const auto vertex : triangles.finite_vertex_handles())
    vertex->info() = -1;
  std::vector<Vertex> vertices;
  for (const Face face : faces)
    for (int i = 0; i < 3; ++i)
      if (face->vertex(i)->info() < 0) {
        face->vertex(i)->info() = static_cast<int>(vertices.size());
        vertices.push_back(face->vertex(i));
      }
  return vertices;
}

int triangulate(const char* in, const char* out) {
  std::ifstream from(in);
  double largest = 0;
  std::size_t lines = 0;
  from >> largest >> lines;
  Triangulation triangles;
  std::list<Point> holes;
  if (!read(from, lines, triangles, holes))
    return 1;
  CGAL::Delaunay_mesher_2<Triangulation, Criteria> mesher(triangles,
                                                          Criteria(shape, largest));
  mesher.set_seeds(holes.begin(), holes.end());
  mesher.refine_mesh();

  std::vector<Face> faces;
  for (const auto face : triangles.finite_face_handles())
    if (face->is_in_domain())
      faces.push_back(face);
  const std::vector<Vertex> vertices = numbered(triangles, faces);
  std::ofstream to(out);
  to << std::setprecision(17) << vertices.size() << ' ' << faces.size() << '\n';
  for (const Vertex vertex : vertices)
    to << vertex->point().x() << ' ' << vertex->point().y() << ' '
       << (triangles.are_there_incident_constraints(vertex) ? 1 : 0) << '\n';
  for (const Face face : faces)
    to << face->vertex(0)->info() << ' ' << face->vertex(1)->info() << ' '
       << face->vertex(2)->info() << '\n';
  to.close();
  return to && !faces.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char* argv[]) {
  try {
    return argc == 3 ? triangulate(argv[1], argv[2]) : 1;
  } catch (const std::exception& error) {
    std::cerr << "triangulate: " << error.what() << '\n';
    return 1;
  }
}
