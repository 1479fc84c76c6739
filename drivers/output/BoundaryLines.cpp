#include "drivers/output/BoundaryLines.hpp"

#include "drivers/output/Csv.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::drivers {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

void add(bem::Vec2 vector, std::vector<double>& numbers) {
  numbers.insert(numbers.end(), {vector.x, vector.y, 0});
}

/// Adds a point.  `contact`: null where there is no contact.
void addPoint(bem::Vec2 place, bem::Vec2 displacement, bem::Vec2 traction,
              const contact::ContactPoint* contact, BoundaryLines& grid) {
  add(place, grid.points);
  add(displacement, grid.displacement);
  add(traction, grid.traction);
  grid.pressure.push_back(contact == nullptr ? nothing : contact->pressure);
  grid.shear.push_back(contact == nullptr ? nothing : contact->shear);
  grid.gap.push_back(contact == nullptr ? nothing : contact->gap);
  grid.contact.push_back(contact == nullptr ? -1 : contact->closed ? 1 : 0);
  grid.friction.push_back(contact == nullptr ? -1 : numberOf(contact->friction));
}

/// Adds the `lines` segments between the `lines` + 1 points that were added last.
void addLines(int lines, int element, int degree, int boundary, int body,
              BoundaryLines& grid) {
  const auto first = static_cast<long long>(grid.pressure.size()) - lines - 1;
  for (int k = 0; k < lines; ++k) {
    grid.ends.insert(grid.ends.end(), {first + k, first + k + 1});
    grid.element.push_back(element);
    grid.degree.push_back(degree);
    grid.boundary.push_back(boundary);
    grid.body.push_back(body);
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

  void sample(int e, BoundaryLines& grid) const {
    const bem::Element& element = mesh()[e];
    const int lines = std::max(2 * (element.degree + 1), linesOf(element.curve));
    for (int k = 0; k <= lines; ++k)
      samplePoint(e, -1 + 2.0 * k / lines, grid);
    addLines(lines, e, element.degree,
             firstBoundary_ + placeOf(mesh().boundary(e), names_), body_, grid);
  }

 private:
  const bem::Mesh& mesh() const { return solved_.space.mesh(); }

  void samplePoint(int e, double t, BoundaryLines& grid) const {
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
              int firstBoundary, BoundaryLines& grid) {
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

VtkGrid BoundaryLines::grid() const {
  return {points,
          ends,
          2,
          "Vectors=\"displacement\"",
          {{"displacement", &displacement, 3},
           {"traction", &traction, 3},
           {"lambda_n", &pressure},
           {"lambda_t", &shear},
           {"gap", &gap},
           {"contact", &contact},
           {"friction", &friction}},
          {{"element", &element},
           {"degree", &degree},
           {"boundary", &boundary},
           {"body", &body}}};
}

BoundaryLines boundaryLines(const Scene& scene, const SolvedLevel& level) {
  BoundaryLines grid;
  int boundaries = 0;
  for (std::size_t b = 0; b < level.bodies.size(); ++b) {
    const bem::Mesh& mesh = level.bodies[b].space.mesh();
    const Sampler sampler(level.bodies[b], level.level.bodies[b].density,
                          static_cast<int>(b), boundaries);
    for (int e = 0; e < mesh.size(); ++e)
      sampler.sample(e, grid);
    boundaries += static_cast<int>(boundaryNames(mesh.outline()).size());
  }
  for (std::size_t k = 0; k < scene.rigid.size(); ++k) {
    contact::RigidMotion motion = level.level.rigid[k];
    motion.slide = scene.units().length * motion.slide;
    addRigid(scene.rigid[k], motion, static_cast<int>(level.bodies.size() + k),
             boundaries, grid);
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

std::string boundaryCsv(const Scene& scene, const BoundaryLines& grid) {
  std::string csv;
  const std::vector<std::string> names = namesOfBoundaries(scene);
  const auto addPoint = [&](std::size_t line, long long point) {
    const auto at = [&](const std::vector<double>& field, int component) {
      return exactly(field[3 * point + component]);
    };
    addRow({{"x", at(grid.points, 0)},
            {"y", at(grid.points, 1)},
            {"ux", at(grid.displacement, 0)},
            {"uy", at(grid.displacement, 1)},
            {"tx", at(grid.traction, 0)},
            {"ty", at(grid.traction, 1)},
            {"boundary", names[grid.boundary[line]]},
            {"element", number(grid.element[line])},
            {"degree", number(grid.degree[line])},
            {"body", scene.bodies[grid.body[line]].name}},
           csv);
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
  return csv;
}

}  // namespace epafi::drivers
