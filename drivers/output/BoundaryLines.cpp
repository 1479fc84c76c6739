#include "drivers/output/BoundaryLines.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/Csv.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace epafi::drivers {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// The fields of a point, and of a segment.
enum { Displacement, Traction, Pressure, Shear, Gap, Contact, Friction };
enum { Element, Degree, Boundary, OfBody };

VtkGrid emptyGrid() {
  const std::vector<double> real;
  const std::vector<int> whole;
  return {2,
          "Vectors=\"displacement\"",
          {{"displacement", real, 3},
           {"traction", real, 3},
           {"lambda_n", real},
           {"lambda_t", real},
           {"gap", real},
           {"contact", whole},
           {"friction", whole}},
          {{"element", whole}, {"degree", whole}, {"boundary", whole}, {"body", whole}}};
}

/// Adds a point.  `contact`: null where there is no contact.
void addPoint(bem::Vec2 place, bem::Vec2 displacement, bem::Vec2 traction,
              const contact::ContactPoint* contact, VtkGrid& grid) {
  std::vector<DataArray>& fields = grid.pointData;
  grid.points.add(place);
  fields[Displacement].add(displacement);
  fields[Traction].add(traction);
  fields[Pressure].add(contact == nullptr ? nothing : contact->pressure);
  fields[Shear].add(contact == nullptr ? nothing : contact->shear);
  fields[Gap].add(contact == nullptr ? nothing : contact->gap);
  fields[Contact].add(contact == nullptr ? -1 : contact->closed ? 1 : 0);
  fields[Friction].add(contact == nullptr ? -1 : numberOf(contact->friction));
}

/// Adds the `lines` segments between the `lines` + 1 points that were added last.
void addLines(int lines, int element, int degree, int boundary, int body, VtkGrid& grid) {
  const auto first = static_cast<long long>(grid.size()) - lines - 1;
  for (int k = 0; k < lines; ++k) {
    grid.corners.insert(grid.corners.end(), {first + k, first + k + 1});
    grid.cellData[Element].add(element);
    grid.cellData[Degree].add(degree);
    grid.cellData[Boundary].add(boundary);
    grid.cellData[OfBody].add(body);
  }
}

int placeOf(const std::string& name, const std::vector<std::string>& names) {
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// Number of segments of an arc: one for every 5 degrees.
int linesOf(const bem::Curve& curve) {
  constexpr double degreesALine = 5;
  const double angle = std::abs(curve.angle()) * 180 / 3.14159265358979;
  return std::max(1, static_cast<int>(std::ceil(angle / degreesALine)));
}

/// Samples the boundary of one elastic body, element by element.
class Sampler {
 public:
  Sampler(const contact::Solved& solved, const bem::Vector& density, int body,
          int firstBoundary)
      : solved_(solved),
        body_(body),
        firstBoundary_(firstBoundary),
        density_(density),
        names_(boundaryNames(mesh().outline())),
        fields_(solved),
        contacts_(static_cast<std::size_t>(mesh().size()), nullptr) {
    for (const auto& element : fields_.elements())
      contacts_[element.element] = &element;
  }

  void sample(int e, VtkGrid& grid) const {
    const bem::Element& element = mesh()[e];
    const int lines = std::max(2 * (element.degree + 1), linesOf(element.curve));
    for (int k = 0; k <= lines; ++k)
      samplePoint(e, -1 + 2.0 * k / lines, grid);
    addLines(lines, e, element.degree,
             firstBoundary_ + placeOf(mesh().boundary(e), names_), body_, grid);
  }

 private:
  const bem::Mesh& mesh() const { return solved_.space.mesh(); }

  void samplePoint(int e, double t, VtkGrid& grid) const {
    const bem::Units& units = solved_.units;
    contact::ContactPoint point;
    const auto* contact = contacts_[e];
    if (contact != nullptr)
      point = fields_.at(*contact, t);
    bem::Vec2 traction = solved_.space.densityAt(density_, e, t);
    if (solved_.conditions.inside)
      traction = traction + solved_.conditions.inside->traction(mesh(), e, t);
    addPoint(mesh().physicalPoint(e, t), units.length * solved_.displacementAt(e, t),
             units.stress * traction, contact == nullptr ? nullptr : &point, grid);
  }

  const contact::Solved& solved_;
  int body_;
  int firstBoundary_;
  const bem::Vector& density_;
  std::vector<std::string> names_;
  contact::ContactFields fields_;
  std::vector<const contact::ContactFields::Element*> contacts_;
};

/// Adds the outline of a rigid body, moved by `motion`, in the user's units.
void addRigid(const RigidBody& body, const contact::RigidMotion& motion, int number,
              int firstBoundary, VtkGrid& grid) {
  const bem::Outline& outline = *body.outline;
  const std::vector<std::string> names = boundaryNames(outline);
  for (std::size_t e = 0; e < outline.edges().size(); ++e) {
    const bem::Edge& edge = outline.edges()[e];
    const int lines = linesOf(edge.curve);
    for (int k = 0; k <= lines; ++k) {
      const bem::Vec2 place = outline.physical(edge.curve.point(-1 + 2.0 * k / lines));
      addPoint(place, motion.at(place - body.pole), {}, nullptr, grid);
    }
    addLines(lines, static_cast<int>(e), 1, firstBoundary + placeOf(edge.boundary, names),
             number, grid);
  }
}

}  // namespace

VtkGrid boundaryLines(const SolvedStep& solved) {
  const Scene& scene = solved.spaces.scene();
  VtkGrid grid = emptyGrid();
  int boundaries = 0;
  for (std::size_t b = 0; b < solved.bodies.size(); ++b) {
    const bem::Mesh& mesh = solved.bodies[b].space.mesh();
    const Sampler sampler(solved.bodies[b], solved.densities[b], static_cast<int>(b),
                          boundaries);
    for (int e = 0; e < mesh.size(); ++e)
      sampler.sample(e, grid);
    boundaries += static_cast<int>(boundaryNames(mesh.outline()).size());
  }
  for (std::size_t k = 0; k < scene.rigid.size(); ++k) {
    addRigid(scene.rigid[k], solved.row.rigid[k].second.motion,
             static_cast<int>(solved.bodies.size() + k), boundaries, grid);
    boundaries += static_cast<int>(boundaryNames(*scene.rigid[k].outline).size());
  }
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
    return std::any_of(scene.contacts.begin(), scene.contacts.end(),
                       [&](const ContactPair& pair) {
                         return pair.side.isOnBodyOf(a) && pair.opposite.isOnBodyOf(b);
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
      if (a == b || std::min(a, b) >= elastic || touch(all[a], all[b]) ||
          touch(all[b], all[a]))
        continue;
      if (const auto x = bodies[a].insideOf(bodies[b], depth))
        return warnings.push_back(bem::message(
            "Bodies: '", scene.nameOf(all[a]), "' and '", scene.nameOf(all[b]),
            "', deformed, overlap by more than ", depth, " at (", x->x, ", ", x->y,
            "), and no contact between them is drawn: add one to Contacts"));
    }
}

std::string boundaryCsv(const Scene& scene, const VtkGrid& grid) {
  std::string csv;
  const std::vector<std::string> names = namesOfBoundaries(scene);
  const std::vector<DataArray>& fields = grid.pointData;
  const auto of = [&](std::size_t line, int field) {
    return grid.cellData[field].at<int>(line);
  };
  const auto addPoint = [&](std::size_t line, long long point) {
    const auto at = [&](const DataArray& field, int component) {
      return exactly(field.at<double>(3 * point + component));
    };
    addRow({{"x", at(grid.points, 0)},
            {"y", at(grid.points, 1)},
            {"ux", at(fields[Displacement], 0)},
            {"uy", at(fields[Displacement], 1)},
            {"tx", at(fields[Traction], 0)},
            {"ty", at(fields[Traction], 1)},
            {"boundary", names[of(line, Boundary)]},
            {"element", number(of(line, Element))},
            {"degree", number(of(line, Degree))},
            {"body", scene.bodies[of(line, OfBody)].name}},
           csv);
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
