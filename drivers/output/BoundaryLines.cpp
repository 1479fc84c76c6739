#include "drivers/output/BoundaryLines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace epafi::drivers {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

void add(bem::Vec2 vector, std::vector<double>& numbers) {
  numbers.insert(numbers.end(), {vector.x, vector.y, 0});
}

/// Fills a grid element by element.
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
      contacts_[static_cast<std::size_t>(element.element)] = &element;
  }

  void sample(int e, BoundaryLines& grid) const {
    const bem::Element& element = mesh()[e];
    const auto first = static_cast<long long>(grid.pressure.size());
    const int lines = linesOf(element);
    for (int k = 0; k <= lines; ++k)
      samplePoint(e, -1 + 2.0 * k / lines, grid);
    const auto name = std::find(names_.begin(), names_.end(), mesh().boundary(e));
    const auto boundary = static_cast<int>(name - names_.begin());
    for (int k = 0; k < lines; ++k) {
      grid.ends.insert(grid.ends.end(), {first + k, first + k + 1});
      grid.element.push_back(e);
      grid.degree.push_back(element.degree);
      grid.boundary.push_back(firstBoundary_ + boundary);
      grid.body.push_back(body_);
    }
  }

 private:
  const bem::Mesh& mesh() const { return solved_.space.mesh(); }

  void samplePoint(int e, double t, BoundaryLines& grid) const {
    add(mesh().physicalPoint(e, t), grid.points);
    add(solved_.units.length * solved_.space.displacementAt(solved_.displacement, e, t),
        grid.displacement);
    add(solved_.units.stress * solved_.space.densityAt(density_, e, t), grid.traction);
    contact::ContactPoint point;
    point.pressure = point.shear = point.gap = nothing;
    const auto* contact = contacts_[static_cast<std::size_t>(e)];
    if (contact != nullptr)
      point = fields_.at(*contact, t);
    grid.pressure.push_back(point.pressure);
    grid.shear.push_back(point.shear);
    grid.gap.push_back(point.gap);
    grid.contact.push_back(contact == nullptr ? -1 : (point.closed ? 1 : 0));
    grid.friction.push_back(contact == nullptr ? -1 : numberOf(point.friction));
  }

  const contact::Solved& solved_;
  int body_;
  int firstBoundary_;
  const bem::Vector& density_;
  std::vector<std::string> names_;
  contact::ContactFields fields_;
  std::vector<const contact::ContactFields::Element*> contacts_;
};

/// Lines for every 5 degrees.
int linesOf(const bem::Curve& curve) {
  constexpr double degreesALine = 5;
  const double angle = std::abs(curve.angle()) * 180 / 3.14159265358979;
  return std::max(1, static_cast<int>(std::ceil(angle / degreesALine)));
}

/// An outline that does not deform, moved in the user's units.
void addRigid(const RigidBody& body, const contact::RigidMotion& motion, int number,
              int firstBoundary, BoundaryLines& grid) {
  const bem::Outline& outline = *body.outline;
  const std::vector<std::string> names = boundaryNames(outline);
  for (std::size_t e = 0; e < outline.edges().size(); ++e) {
    const bem::Edge& edge = outline.edges()[e];
    const int lines = linesOf(edge.curve);
    const auto first = static_cast<long long>(grid.pressure.size());
    for (int k = 0; k <= lines; ++k) {
      const bem::Vec2 place = outline.physical(edge.curve.point(-1 + 2.0 * k / lines));
      add(place, grid.points);
      add(motion.at(place - body.pole), grid.displacement);
      add({}, grid.traction);
      for (std::vector<double>* none : {&grid.pressure, &grid.shear, &grid.gap})
        none->push_back(nothing);
      grid.contact.push_back(-1);
      grid.friction.push_back(-1);
    }
    const auto name = std::find(names.begin(), names.end(), edge.boundary);
    for (int k = 0; k < lines; ++k) {
      grid.ends.insert(grid.ends.end(), {first + k, first + k + 1});
      grid.element.push_back(static_cast<int>(e));
      grid.degree.push_back(1);
      grid.boundary.push_back(firstBoundary + static_cast<int>(name - names.begin()));
      grid.body.push_back(number);
    }
  }
}

}  // namespace

int linesOf(const bem::Element& element) {
  return std::max(2 * (element.degree + 1), linesOf(element.curve));
}

int numberOf(contact::FrictionKind friction) {
  switch (friction) {
    case contact::FrictionKind::Stick:
      return 1;
    case contact::FrictionKind::Slip:
      return 2;
    case contact::FrictionKind::None:
      break;
  }
  return 0;
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

std::vector<std::string> boundaryNames(const bem::Outline& outline) {
  std::vector<std::string> names;
  for (const bem::Edge& edge : outline.edges())
    if (std::find(names.begin(), names.end(), edge.boundary) == names.end())
      names.push_back(edge.boundary);
  return names;
}

}  // namespace epafi::drivers
