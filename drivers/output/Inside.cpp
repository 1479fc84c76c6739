#include "drivers/output/Inside.hpp"

#include "bem/base/Error.hpp"
#include "bem/base/Parallel.hpp"
#include "drivers/output/Table.hpp"
#include "drivers/output/VtkGrid.hpp"
#include "drivers/process/ChildProgram.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <limits>
#include <string>
#include <unistd.h>
#include <vector>

namespace epafi::drivers {

BodyInsides::BodyInsides(const Scene& scene, const Level& level, const SolvedState& step)
    : scene_(scene), spaces_(scene, level) {
  for (const auto& conditions :
       spaces_.conditionsAt(level.timeOf(step, scene.endOfPath())))
    inside_.push_back(conditions.inside);
  for (std::size_t b = 0; b < size(); ++b) {
    surfaces_.emplace_back(spaces_.space(b), scene.lame(b), step.displacement[b],
                           step.density[b]);
    fields_.emplace_back(spaces_.space(b), scene.lame(b), step.displacement[b],
                         step.density[b]);
  }
}

namespace {

InsideValue inUnits(const bem::InteriorValue& field, const bem::Material& material,
                    const bem::Units& units, const contact::BodyLoadSolution& inside,
                    const contact::ParticularSolution::Value& particular) {
  InsideValue value;
  value.displacement = units.length * field.displacement;
  value.xx = units.stress * field.xx;
  value.yy = units.stress * field.yy;
  value.xy = units.stress * field.xy;
  value.zz = units.stress * field.zz;
  if (inside) {
    const contact::BodyStress& stress = particular.stress;
    value.displacement = value.displacement + units.length * particular.displacement;
    value.xx += units.stress * stress.xx;
    value.yy += units.stress * stress.yy;
    value.xy += units.stress * stress.xy;
    value.zz += units.stress * stress.hoop;
  }
  if (!units.isAxisymmetric)
    value.zz = material.planeStress ? 0 : material.poissonsRatio * (value.xx + value.yy);
  if (inside) {
    value.zz += units.stress * inside->stressAcross(particular.temperature);
    value.temperature = particular.temperature;
  }
  const double a = value.xx - value.yy;
  const double b = value.yy - value.zz;
  const double c = value.zz - value.xx;
  value.vonMises = std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * value.xy * value.xy);
  const double radius = std::hypot(0.5 * a, value.xy);
  value.principal1 = 0.5 * (value.xx + value.yy) + radius;
  value.principal2 = 0.5 * (value.xx + value.yy) - radius;
  return value;
}

}  // namespace

// Conducted heat has its own temperature there, which no integral has to give.
InsideValue stressAt(const bem::InteriorValue& field, const bem::Material& material,
                     const bem::Units& units, const contact::BodyLoadSolution& inside,
                     const bem::Mesh& mesh, int e, double t) {
  return inUnits(field, material, units, inside,
                 inside ? inside->on(mesh, e, t) : contact::ParticularSolution::Value{});
}

std::string nameOf(const InsideField& field, bool isAxisymmetric) {
  InsideValue value;
  return isAxisymmetric && &field.of(value) == &value.zz ? hoop : field.name;
}

InsideValue BodyInsides::atBoundary(std::size_t b, int e, double t) const {
  return stressAt(surfaces_[b].at(e, t), scene_.bodies[b].material, scene_.units(),
                  inside_[b], mesh(b), e, t);
}

std::vector<InsideValue> BodyInsides::at(const std::vector<InsidePoint>& points) const {
  std::vector<InsideValue> values(points.size());
  for (std::size_t b = 0; b < size(); ++b) {
    std::vector<std::size_t> own;
    std::vector<bem::Vec2> places;
    std::vector<bem::Vec2> there;
    for (std::size_t k = 0; k < points.size(); ++k)
      if (points[k].body == b) {
        own.push_back(k);
        bem::Vec2 x = points[k].x;
        bem::Vec2 drawn = scene_.drawn(x);
        there.push_back(drawn);
        if (scene_.isAxisymmetric)  // beside the axis by nothing
          drawn.x = std::abs(x.x);
        places.push_back(mesh(b).outline().scaled(drawn));
      }
    const std::vector<bem::InteriorValue> fields = fields_[b].at(places);
    std::vector<contact::ParticularSolution::Value> particular(places.size());
    if (inside_[b])
      particular = inside_[b]->at(places);
    for (std::size_t k = 0; k < own.size(); ++k) {
      InsideValue& value = values[own[k]];
      value = inUnits(fields[k], scene_.bodies[b].material, scene_.units(), inside_[b],
                      particular[k]);
      for (const Symmetry& line : scene_.mirrors()) {
        bem::Vec2 x = points[own[k]].x;
        if (line.across(x) * line.across(there[k]) < 0) {
          value.displacement = line.mirrored(value.displacement);
          value.xy = -value.xy;
        }
      }
    }
  }
  return values;
}

Cells insideCells(bem::Vec2 x, InsideValue value, const std::string* body,
                  bool isAxisymmetric) {
  Cells cells = {{"x", x.x, "the point", "length"}, {"y", x.y}};
  for (const InsideField& field : insideFields) {
    cells.push_back({nameOf(field, isAxisymmetric),
                     body == nullptr ? Value("") : Value(field.of(value)), field.meaning,
                     field.unit});
    if (&field.of(value) == &value.vonMises)
      cells.push_back(
          {"body", body == nullptr ? "" : *body, "the body in which the point lies"});
  }
  return cells;
}

void BodyInsides::addTo(std::string& csv, const std::vector<InsidePoint>& points,
                        const std::vector<InsideValue>& values,
                        const std::vector<Cells>& more) const {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t b = points[i].body;
    Cells row = insideCells(points[i].x, values[i],
                            b == size() ? nullptr : &scene_.bodies[b].name,
                            scene_.isAxisymmetric);
    if (!more.empty())
      append(row, more[i]);
    addRow(row, csv);
  }
}

namespace {

namespace fs = std::filesystem;

/// The inside of a body as triangles, which are small at small elements.
struct Triangulation {
  std::vector<bem::Vec2> points;            ///< in the user's coordinates
  std::vector<bool> onBoundary;             ///< of each point
  std::vector<std::array<int, 3>> corners;  ///< of each triangle, counter-clockwise
};

/// Largest size of a triangle, over the diameter of the outline.
constexpr double largest = 1.0 / 40;
/// Nodes closer than this are merged: no plot can separate them.
constexpr double smallest = 1e-7;

/// A temporary folder, deleted by the destructor.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "epafi-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw bem::InputError("fields: no folder can be made in '",
                            fs::temp_directory_path().string(),
                            "': ", std::strerror(errno));
    path_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

/// The vertices of each closed line.
std::vector<std::vector<bem::Vec2>> polygons(const bem::Mesh& mesh) {
  std::vector<std::vector<bem::Vec2>> loops(
      static_cast<std::size_t>(mesh.outline().loops()));
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::Element& element = mesh[e];
    auto& loop = loops[mesh.outline().edge(element.piece.edge).loop];
    const double angle = std::abs(element.curve.angle());
    const int parts = std::max(static_cast<int>(std::ceil(2 * element.half / largest)),
                               static_cast<int>(std::ceil(angle / 0.1)));
    for (int k = 0; k < std::max(parts, 1); ++k) {
      const bem::Vec2 x = element.curve.point(-1 + 2.0 * k / std::max(parts, 1));
      if (loop.empty() ||
          (norm(x - loop.back()) > smallest && norm(x - loop.front()) > smallest))
        loop.push_back(x);
    }
  }
  return loops;
}

void writeOutline(const std::string& file,
                  const std::vector<std::vector<bem::Vec2>>& loops) {
  std::ofstream out(file);
  out << std::setprecision(17) << largest << "\n" << loops.size() << "\n";
  for (const auto& loop : loops) {
    out << loop.size() << "\n";
    for (const bem::Vec2& x : loop)
      out << x.x << " " << x.y << "\n";
  }
}

Triangulation readTriangles(const std::string& file, const bem::Outline& outline) {
  std::ifstream in(file);
  std::size_t points = 0;
  std::size_t triangles = 0;
  in >> points >> triangles;
  Triangulation result;
  for (std::size_t i = 0; i < points && in; ++i) {
    bem::Vec2 x;
    int boundary = 0;
    in >> x.x >> x.y >> boundary;
    result.points.push_back(outline.physical(x));
    result.onBoundary.push_back(boundary != 0);
  }
  for (std::size_t i = 0; i < triangles && in; ++i) {
    std::array<int, 3> corners{};
    in >> corners[0] >> corners[1] >> corners[2];
    result.corners.push_back(corners);
  }
  if (!in || triangles == 0)
    throw bem::InputError("fields: the inside cannot be cut into triangles: none came");
  return result;
}

/// Delaunay triangles with angles of at least 20 degrees where the outline permits, and
/// sizes up to a fortieth of its diameter.  Their boundary consists of the nodes of the
/// elements and of points between them as the size requires.
///
/// Runs ../libexec/epafi/triangulate (relative to this program), which uses CGAL.
/// \throws bem::InputError if that program is missing or fails.
Triangulation triangulate(const bem::Mesh& mesh) {
  const Scratch scratch;
  const std::string in = scratch.file("outline");
  const std::string out = scratch.file("triangles");
  writeOutline(in, polygons(mesh));
  const std::string program = besideProgram("libexec/epafi/triangulate");
  if (!runChild(program, {in, out}, "fields",
                "it is built and installed along with epafi"))
    throw bem::InputError("fields: the inside cannot be cut into triangles: '", program,
                          "' failed");
  return readTriangles(out, mesh.outline());
}

/// The elements of a mesh in a tree, in their order.
bem::CurveTree elementsOf(const bem::Mesh& mesh) {
  std::vector<bem::Curve> curves;
  for (const bem::Element& element : mesh.elements())
    curves.push_back(element.curve);
  return bem::CurveTree(std::move(curves));
}

InsideValue mean(InsideValue a, InsideValue b) {
  for (const InsideField& field : insideFields)
    field.of(a) = 0.5 * (field.of(a) + field.of(b));
  return a;
}

InsideValue onBoundary(const BodyInsides& insides, const InsidePoint& point,
                       const bem::CurveTree& elements) {
  constexpr double node = 0.999;
  const bem::Mesh& mesh = insides.mesh(point.body);
  const bem::CurveTree::Foot foot = elements.nearest(mesh.outline().scaled(point.x));
  const auto element = static_cast<int>(foot.curve);
  const InsideValue own = insides.atBoundary(point.body, element, foot.t);
  const auto withEndOf = [&](int other, double end) {
    const InsideValue there = insides.atBoundary(point.body, other, end);
    return mesh.isAxis(element) ? there : mesh.isAxis(other) ? own : mean(own, there);
  };
  if (foot.t > node)
    return withEndOf(mesh[element].next, -1);
  if (foot.t < -node)
    return withEndOf(mesh[element].previous, 1);
  return own;
}

}  // namespace

FilledBodies fill(const BodyInsides& insides) {
  FilledBodies all;
  all.isAxisymmetric = insides.scene().isAxisymmetric;
  for (std::size_t b = 0; b < insides.size(); ++b) {
    const Triangulation own = triangulate(insides.mesh(b));
    std::vector<InsidePoint> points;
    for (const bem::Vec2 x : own.points)
      points.push_back({b, x});
    std::vector<InsideValue> values(points.size());
    std::vector<std::size_t> boundary;
    std::vector<std::size_t> inside;
    for (std::size_t i = 0; i < points.size(); ++i)
      (own.onBoundary[i] || !insides.mesh(b).outline().contains(points[i].x) ? boundary
                                                                             : inside)
          .push_back(i);
    const bem::CurveTree elements = elementsOf(insides.mesh(b));
    constexpr double ofPoint = 2000;  // ns
    const auto n = static_cast<bem::Index>(boundary.size());
    bem::parallelFor({n, ofPoint * static_cast<double>(n), 16}, [&](bem::Index k) {
      values[boundary[bem::at(k)]] =
          onBoundary(insides, points[boundary[bem::at(k)]], elements);
    });
    std::vector<InsidePoint> places;
    std::transform(inside.begin(), inside.end(), std::back_inserter(places),
                   [&](std::size_t i) { return points[i]; });
    const std::vector<InsideValue> there = insides.at(places);
    for (std::size_t k = 0; k < inside.size(); ++k)
      values[inside[k]] = there[k];
    const auto first = static_cast<int>(all.values.size());
    for (const auto& c : own.corners)
      all.corners.push_back({first + c[0], first + c[1], first + c[2]});
    all.points.insert(all.points.end(), points.begin(), points.end());
    all.values.insert(all.values.end(), values.begin(), values.end());
  }
  return all;
}

std::string vtuFile(const FilledBodies& bodies) {
  VtkGrid grid{3,
               R"(Scalars="von_mises" Vectors="displacement")",
               {{"displacement", std::vector<double>(), 3}}};
  for (const InsideField& field : insideFields)
    grid.pointData.push_back(
        {nameOf(field, bodies.isAxisymmetric), std::vector<double>()});
  grid.pointData.push_back({"body", std::vector<int>()});
  for (std::size_t i = 0; i < bodies.points.size(); ++i) {
    InsideValue value = bodies.values[i];
    auto array = grid.pointData.begin();
    grid.points.add(bodies.points[i].x);
    (array++)->add(value.displacement);
    for (const InsideField& field : insideFields)
      (array++)->add(field.of(value));
    array->add(static_cast<int>(bodies.points[i].body));
  }
  for (const auto& triangle : bodies.corners)
    grid.corners.insert(grid.corners.end(), triangle.begin(), triangle.end());
  return vtuText(grid);
}

std::vector<std::string> fieldNames() {
  std::vector<std::string> names;
  for (const InsideField& field : insideFields)
    names.emplace_back(field.name);
  names.emplace_back(hoop);
  return names;
}

}  // namespace epafi::drivers
