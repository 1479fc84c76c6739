#include "drivers/output/BoundaryLines.hpp"

#include "bem/base/Error.hpp"
#include "drivers/output/Csv.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

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
  std::vector<VtkArray>& fields = grid.pointData;
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
    addRigid(scene.rigid[k], solved.row.rigid[k].summary.motion,
             static_cast<int>(solved.bodies.size() + k), boundaries, grid);
    boundaries += static_cast<int>(boundaryNames(*scene.rigid[k].outline).size());
  }
  return grid;
}

std::vector<std::string> namesOfBoundaries(const Scene& scene) {
  std::vector<std::string> all;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    for (const std::string& name : boundaryNames(*scene.bodies[b].outline))
      all.push_back(scene.boundaryName(b, name));
  for (const RigidBody& body : scene.rigid)
    for (const std::string& name : boundaryNames(*body.outline))
      all.push_back(body.name + ":" + name);
  return all;
}

void findOverlap(const Scene& scene, const VtkGrid& grid,
                 std::vector<std::string>& warnings) {
  using bem::Vec2;
  constexpr double share = 0.1;
  const std::size_t elastic = scene.bodies.size();
  struct Deformed {
    std::vector<std::pair<Vec2, Vec2>> lines{};
    Vec2 low{std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()};
    Vec2 high = -1.0 * low;
  };
  std::vector<Deformed> bodies(elastic + scene.rigid.size());
  double depth = 0;
  double drawn = 0;  // on one side of a line of symmetry: farthest from it
  const auto across = [&](Vec2 x) { return scene.symmetry.across(x); };
  const auto moved = [&](long long k) {
    const VtkArray& motion = grid.pointData[Displacement];
    const Vec2 u{motion.at<double>(3 * k), motion.at<double>(3 * k + 1)};
    const Vec2 x{grid.points.at<double>(3 * k), grid.points.at<double>(3 * k + 1)};
    depth = std::max(depth, share * norm(u));
    drawn = std::abs(across(x)) > std::abs(drawn) ? across(x) : drawn;
    return x + u;
  };
  for (std::size_t k = 0; 2 * k < grid.corners.size(); ++k) {
    auto& [lines, low, high] = bodies[grid.cellData[OfBody].at<int>(k)];
    lines.emplace_back(moved(grid.corners[2 * k]), moved(grid.corners[2 * k + 1]));
    const Vec2 end = lines.back().first;
    low = {std::min(low.x, end.x), std::min(low.y, end.y)};
    high = {std::max(high.x, end.x), std::max(high.y, end.y)};
  }
  const auto nameOf = [&](std::size_t b) {
    return b < elastic ? scene.bodies[b].name : scene.rigid[b - elastic].name;
  };
  for (std::size_t b = 0; scene.symmetry && b < bodies.size(); ++b) {
    const double beyond = drawn > 0 ? -across(bodies[b].low) : across(bodies[b].high);
    if (beyond > depth)
      return warnings.push_back(bem::message(
          "Bodies: '", nameOf(b), "', deformed, overlaps its mirror image: it lies ",
          beyond, " beyond the line of symmetry ", scene.symmetry.line(),
          b < elastic ? "; let its side meet an obstacle there: Type = Contact, Gap"
                      : ""));
  }
  std::set<std::pair<std::string, std::string>> met;
  for (const ContactPair& pair : scene.contacts)
    met.emplace(scene.nameOf(pair.side), scene.nameOf(pair.opposite));
  for (std::size_t a = 0; a < bodies.size(); ++a)
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      if (a == b || std::min(a, b) >= elastic ||
          met.count({nameOf(a), nameOf(b)}) + met.count({nameOf(b), nameOf(a)}) > 0)
        continue;
      const auto& [lines, low, high] = bodies[b];
      for (const auto& [from, to] : bodies[a].lines) {
        const Vec2 along = to - from;
        const Vec2 x = from + 0.5 * along + depth / norm(along) * turnLeft(along);
        if (!(low.x < x.x && x.x < high.x && low.y < x.y && x.y < high.y))
          continue;
        bool isInside = false;
        for (const auto& [p, q] : lines)
          if ((p.y > x.y) != (q.y > x.y) && (cross(q - p, x - p) > 0) == (q.y > p.y))
            isInside = !isInside;
        if (isInside && depth > 0)
          return warnings.push_back(bem::message(
              "Bodies: '", nameOf(a), "' and '", nameOf(b),
              "', deformed, overlap by more than ", depth, " at (", x.x, ", ", x.y,
              "), and no contact between them is drawn: add one to Contacts"));
      }
    }
}

std::string boundaryCsv(const Scene& scene, const VtkGrid& grid) {
  std::string csv;
  const std::vector<std::string> names = namesOfBoundaries(scene);
  const std::vector<VtkArray>& fields = grid.pointData;
  const auto of = [&](std::size_t line, int field) {
    return grid.cellData[field].at<int>(line);
  };
  const auto addPoint = [&](std::size_t line, long long point) {
    const auto at = [&](const VtkArray& field, int component) {
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
