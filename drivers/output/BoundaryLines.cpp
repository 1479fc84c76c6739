#include "drivers/output/BoundaryLines.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/Inside.hpp"
#include "drivers/output/SurfaceStress.hpp"
#include "drivers/output/Table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace epafi::drivers {

namespace {

// The fields of a point, and of a segment.
enum {
  Displacement,
  Traction,
  LambdaN,
  LambdaT,
  Gap,
  Contact,
  Friction,
  Along,
  VonMises,
  Pressure,
  Shear,
  Hoop  ///< of solids of revolution
};
enum { Element, Degree, Boundary, OfBody, Edge };

VtkGrid emptyGrid(bool isAxisymmetric) {
  const std::vector<double> real;
  const std::vector<int> whole;
  VtkGrid grid{2,
               "Vectors=\"displacement\"",
               {{"displacement", real, 3},
                {"traction", real, 3},
                {"lambda_n", real},
                {"lambda_t", real},
                {"gap", real},
                {"contact", whole},
                {"friction", whole},
                {"stress_t", real},
                {"von_mises", real},
                {"pressure", real},
                {"shear", real}},
               {{"element", whole},
                {"degree", whole},
                {"boundary", whole},
                {"body", whole},
                {"edge", whole}}};
  if (isAxisymmetric)
    grid.pointData.push_back({hoop, real});
  return grid;
}

/// Stress at the surface of a body.
struct Surface {
  double along = std::numeric_limits<double>::quiet_NaN();  ///< normal stress along it
  double vonMises = along;
  double hoop = along;
};

/// What is told of contact at a point.
struct Touch {
  contact::ContactPoint point;
  contact::MultiplierSpace::Value shown;  ///< its stresses without jumps at nodes
};

/// Adds a point.  `touch`: empty where there is no contact.
void addPoint(bem::Vec2 place, bem::Vec2 displacement, bem::Vec2 traction,
              const std::optional<Touch>& touch, const Surface& surface, VtkGrid& grid) {
  const contact::ContactPoint* contact = touch ? &touch->point : nullptr;
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  std::vector<DataArray>& fields = grid.pointData;
  grid.points.add(place);
  fields[Displacement].add(displacement);
  fields[Traction].add(traction);
  fields[LambdaN].add(touch ? contact->pressure : nothing);
  fields[LambdaT].add(touch ? contact->shear : nothing);
  fields[Gap].add(touch ? contact->gap : nothing);
  fields[Contact].add(touch ? static_cast<int>(contact->closed) : -1);
  fields[Friction].add(touch ? numberOf(contact->friction) : -1);
  fields[Pressure].add(touch ? touch->shown.normal : nothing);
  fields[Shear].add(touch ? touch->shown.tangential : nothing);
  fields[Along].add(surface.along);
  fields[VonMises].add(surface.vonMises);
  if (fields.size() > Hoop)
    fields[Hoop].add(surface.hoop);
}

/// Adds a curve as segments: at least `lines`, and one for every 5 degrees.
/// \param of the fields of each of them
/// \param addAt adds the point t in [-1, 1]
template <class AddAt>
void addCurve(const bem::Curve& curve, int lines, const std::array<int, 5>& of,
              VtkGrid& grid, const AddAt& addAt) {
  constexpr double degreesALine = 5;
  const double angle = std::abs(curve.angle()) * 180 / 3.14159265358979;
  lines = std::max(lines, static_cast<int>(std::ceil(angle / degreesALine)));
  auto first = static_cast<long long>(grid.size());
  for (int k = 0; k <= lines; ++k)
    addAt(-1 + 2.0 * k / lines);
  for (int k = 0; k < lines; ++k, ++first) {
    grid.corners.insert(grid.corners.end(), {first, first + 1});
    for (std::size_t field = 0; field < of.size(); ++field)
      grid.cellData[field].add(of[field]);
  }
}

/// The number of each boundary by its name.
using Numbers = std::map<std::string, int>;

/// Adds the boundary of an elastic body, element by element.
void addElastic(const SolvedStep& step, std::size_t b, const Numbers& numbers,
                VtkGrid& grid) {
  const Scene& scene = step.spaces.scene();
  const contact::Solved& solved = step.bodies[b];
  const bem::Mesh& mesh = solved.space.mesh();
  const contact::ContactFields fields(solved);
  const bem::Vector continuous = fields.continuous();
  std::vector<const contact::ContactFields::Element*> contacts(bem::at(mesh.size()));
  for (const auto& element : fields.elements())
    contacts[element.element] = &element;
  const SurfaceField surface(solved.space, scene.lame(b), solved.displacement,
                             step.densities[b]);
  for (int e = 0; e < mesh.size(); ++e) {
    const bem::Element& element = mesh[e];
    const int boundary = numbers.at(scene.boundaryName({false, b, mesh.boundary(e)}));
    addCurve(element.curve, 2 * (element.degree + 1),
             {e, element.degree, boundary, static_cast<int>(b), element.piece.edge}, grid,
             [&](double t) {
               std::optional<Touch> touch;
               if (contacts[e] != nullptr)
                 touch = Touch{fields.at(*contacts[e], t),
                               fields.inUnits(continuous, *contacts[e], t)};
               bem::Vec2 traction = solved.space.densityAt(step.densities[b], e, t);
               if (solved.conditions.inside)
                 traction = traction + solved.conditions.inside->traction(mesh, e, t);
               const InsideValue stress =
                   stressAt(surface.at(e, t), scene.bodies[b].material, solved.units,
                            solved.conditions.inside, mesh, e, t);
               addPoint(
                   mesh.physicalPoint(e, t),
                   mesh.isAxis(e) ? stress.displacement
                                  : solved.units.length * solved.displacementAt(e, t),
                   solved.units.stress * traction, touch,
                   {stress.along(element.curve.tangent(t)), stress.vonMises, stress.zz},
                   grid);
             });
  }
}

/// Adds the outline of a rigid body, moved by `motion`, in the user's units.
void addRigid(const Scene& scene, std::size_t k, const contact::RigidMotion& motion,
              const Numbers& numbers, VtkGrid& grid) {
  const RigidBody& body = scene.rigid[k];
  const int number = static_cast<int>(scene.bodies.size() + k);
  int e = 0;
  for (const bem::Edge& edge : body.outline->edges()) {
    const int boundary = numbers.at(scene.boundaryName({true, k, edge.boundary}));
    addCurve(edge.curve, 1, {e, 1, boundary, number, e}, grid, [&](double t) {
      const bem::Vec2 place = body.outline->physical(edge.curve.point(t));
      addPoint(place, motion.at(place - body.pole), {}, {}, {}, grid);
    });
    ++e;
  }
}

}  // namespace

VtkGrid boundaryLines(const SolvedStep& solved) {
  const Scene& scene = solved.spaces.scene();
  Numbers numbers;
  for (const std::string& name : namesOfBoundaries(scene))
    numbers.emplace(name, static_cast<int>(numbers.size()));
  VtkGrid grid = emptyGrid(scene.isAxisymmetric);
  for (std::size_t b = 0; b < solved.bodies.size(); ++b)
    addElastic(solved, b, numbers, grid);
  for (std::size_t k = 0; k < scene.rigid.size(); ++k)
    addRigid(scene, k, solved.row.rigid[k].second.motion, numbers, grid);
  return grid;
}

std::vector<std::string> namesOfBoundaries(const Scene& scene) {
  std::vector<std::string> all;
  for (SideOfBody side : scene.everyBody())
    for (const std::string& name : boundaryNames(scene.outlineOf(side))) {
      side.boundary = name;
      all.push_back(scene.boundaryName(side));
    }
  return all;
}

namespace {

/// The deformed boundary of a body as closed polygons.
class DeformedBody {
 public:
  void add(bem::Vec2 from, bem::Vec2 to) {
    lines_.emplace_back(from, to);
    low_ = {std::min(low_.x, from.x), std::min(low_.y, from.y)};
    high_ = {std::max(high_.x, from.x), std::max(high_.y, from.y)};
  }

  /// A point of this body at a depth below its boundary that is inside of the other one, too.
  std::optional<bem::Vec2> insideOf(const DeformedBody& other, double depth) const {
    for (const auto& [from, to] : lines_) {
      const bem::Vec2 along = to - from;
      const bem::Vec2 x = from + 0.5 * along + depth / norm(along) * turnLeft(along);
      if (other.contains(x))
        return x;
    }
    return std::nullopt;
  }

  bem::Vec2 low() const { return low_; }
  bem::Vec2 high() const { return high_; }

 private:
  bool contains(bem::Vec2 x) const {
    if (!(low_.x < x.x && x.x < high_.x && low_.y < x.y && x.y < high_.y))
      return false;
    bool inside = false;
    for (const auto& [p, q] : lines_)
      if ((p.y > x.y) != (q.y > x.y) && (cross(q - p, x - p) > 0) == (q.y > p.y))
        inside = !inside;
    return inside;
  }

  std::vector<std::pair<bem::Vec2, bem::Vec2>> lines_;
  bem::Vec2 low_{std::numeric_limits<double>::infinity(),
                 std::numeric_limits<double>::infinity()};
  bem::Vec2 high_ = -1.0 * low_;
};

}  // namespace

void findOverlap(const Scene& scene, const VtkGrid& grid,
                 std::vector<std::string>& warnings) {
  using bem::Vec2;
  constexpr double share = 0.1;
  const std::size_t elastic = scene.bodies.size();
  const std::vector<SideOfBody> all = scene.everyBody();
  std::vector<DeformedBody> bodies(all.size());
  double depth = 1e-12 * scene.units().length;  // of bodies drawn flush, less is rounding
  double drawn = 0;  // on one side of a line of symmetry: farthest from it
  const auto across = [&](Vec2 x) { return scene.symmetry.across(x); };
  const auto moved = [&](long long k) {
    const DataArray& motion = grid.pointData[Displacement];
    const Vec2 u{motion.at<double>(3 * k), motion.at<double>(3 * k + 1)};
    const Vec2 x{grid.points.at<double>(3 * k), grid.points.at<double>(3 * k + 1)};
    depth = std::max(depth, share * norm(u));
    drawn = std::abs(across(x)) > std::abs(drawn) ? across(x) : drawn;
    return x + u;
  };
  for (std::size_t k = 0; 2 * k < grid.corners.size(); ++k)
    bodies[grid.cellData[OfBody].at<int>(k)].add(moved(grid.corners[2 * k]),
                                                 moved(grid.corners[2 * k + 1]));
  const auto touch = [&](const SideOfBody& a, const SideOfBody& b) {
    return std::any_of(
        scene.contacts.begin(), scene.contacts.end(), [&](const ContactPair& pair) {
          return (pair.side.isOnBodyOf(a) && pair.opposite.isOnBodyOf(b)) ||
                 (pair.side.isOnBodyOf(b) && pair.opposite.isOnBodyOf(a));
        });
  };
  for (std::size_t b = 0; scene.symmetry && b < bodies.size(); ++b) {
    const double beyond = drawn > 0 ? -across(bodies[b].low()) : across(bodies[b].high());
    if (beyond > depth)
      return warnings.push_back(bem::message(
          "Bodies: '", scene.nameOf(all[b]),
          "', deformed, overlaps its mirror image: it lies ", beyond,
          " beyond the line of symmetry ", scene.symmetry.line(),
          b < elastic ? "; let its side meet an obstacle there: Type = Contact, Gap"
                      : ""));
  }
  for (std::size_t a = 0; a < bodies.size(); ++a)
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      if (a == b || std::min(a, b) >= elastic || touch(all[a], all[b]))
        continue;
      if (const auto x = bodies[a].insideOf(bodies[b], depth))
        return warnings.push_back(bem::message(
            "Bodies: '", scene.nameOf(all[a]), "' and '", scene.nameOf(all[b]),
            "', deformed, overlap by more than ", depth, " at (", x->x, ", ", x->y,
            "), and no contact between them is drawn: add one to Contacts"));
    }
}

Cells cellsOf(const BoundaryRow& row) {
  Cells cells = {{"x", row.x.x, "the point", "length"},
                 {"y", row.x.y},
                 {"ux", row.displacement.x, "displacement", "length"},
                 {"uy", row.displacement.y},
                 {"tx", row.traction.x, "traction σ n", "stress"},
                 {"ty", row.traction.y},
                 {"boundary", row.boundary,
                  "the boundary, element, body and edge of its outline (from 0, holes "
                  "last) on which "
                  "it lies; the element's degree"},
                 {"element", row.element},
                 {"degree", row.degree},
                 {"body", row.body},
                 {"edge", row.edge},
                 {"stress_t", row.along,
                  "on the boundary itself: normal stress along it, tension positive, of "
                  "the traction "
                  "and of the strain along it; von Mises stress",
                  "stress"},
                 {"von_mises", row.vonMises}};
  if (row.around)
    cells.push_back(
        {hoop, *row.around,
         "of [solids of revolution](tutorial.md#revolution): stress around the "
         "axis, on the boundary itself; on the axis that of the inside, as all "
         "columns there",
         "stress"});
  return cells;
}

std::string boundaryCsv(const Scene& scene, const VtkGrid& grid) {
  std::string csv;
  const std::vector<std::string> names = namesOfBoundaries(scene);
  const std::vector<DataArray>& fields = grid.pointData;
  const auto of = [&](std::size_t line, int field) {
    return grid.cellData[field].at<int>(line);
  };
  const auto addPoint = [&](std::size_t line, long long point) {
    const auto vector = [&](const DataArray& field) {
      return bem::Vec2{field.at<double>(3 * point), field.at<double>(3 * point + 1)};
    };
    const auto number = [&](int field) { return fields[field].at<double>(point); };
    BoundaryRow row{vector(grid.points),
                    vector(fields[Displacement]),
                    vector(fields[Traction]),
                    names[of(line, Boundary)],
                    of(line, Element),
                    of(line, Degree),
                    scene.bodies[of(line, OfBody)].name,
                    of(line, Edge),
                    number(Along),
                    number(VonMises)};
    if (fields.size() > Hoop)
      row.around = number(Hoop);
    addRow(cellsOf(row), csv);
  };
  const std::size_t lines = grid.corners.size() / 2;
  const auto deforms = [&](std::size_t line) {
    return line < lines && of(line, OfBody) < static_cast<int>(scene.bodies.size());
  };
  for (std::size_t line = 0; deforms(line); ++line) {
    addPoint(line, grid.corners[2 * line]);
    const bool endsElement =
        !deforms(line + 1) || grid.corners[2 * line + 2] != grid.corners[2 * line + 1];
    if (endsElement)
      addPoint(line, grid.corners[2 * line + 1]);
  }
  return csv;
}

}  // namespace epafi::drivers
