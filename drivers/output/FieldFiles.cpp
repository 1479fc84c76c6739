#include "drivers/output/FieldFiles.hpp"

#include "drivers/output/Csv.hpp"

#include <array>

namespace epafi::drivers {

namespace {

/// Where contact boundaries are: the distance along them from where each chain of elements
/// that follow one another begins.
class ArcLength {
 public:
  ArcLength(const bem::Mesh& mesh, double length) : mesh_(mesh), length_(length) {}

  /// Of the elements in the order of a multiplier; t in [-1, 1].
  double at(const contact::MultiplierSpace::ContactElement& element, double t) {
    if (&element != last_) {
      const bool follows = last_ != nullptr &&
                           mesh_[last_->element].next == element.element &&
                           last_->condition == element.condition;
      start_ = follows ? start_ + 2 * mesh_[last_->element].half : 0;
      last_ = &element;
    }
    return length_ * (start_ + mesh_[element.element].half * (1 + t));
  }

 private:
  const bem::Mesh& mesh_;
  double length_;
  const contact::MultiplierSpace::ContactElement* last_ = nullptr;
  double start_ = 0;
};

}  // namespace

std::string contactCsv(const Scene& scene, const std::vector<contact::Solved>& bodies,
                       const MoreContactColumns& more) {
  std::vector<std::string> names = {"boundary", "element",      "x",       "y",
                                    "lambda_n", "lambda_t",     "u_n",     "u_t",
                                    "gap",      "bound",        "contact", "friction",
                                    "body",     "contact_name", "s"};
  names.insert(names.end(), more.names.begin(), more.names.end());
  Csv csv(names);
  const int samples = scene.output.contactSamples;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const contact::ContactFields fields(bodies[b]);
    ArcLength arc(bodies[b].space.mesh(), bodies[b].units.length);
    for (const auto& element : fields.elements())
      for (int k = 0; k < samples; ++k) {
        const double t = -1 + (2.0 * k + 1) / samples;
        const contact::ContactPoint p = fields.at(element, t);
        const std::string& name = element.condition->name;
        std::vector<std::string> cells = {scene.boundaryName(b, *element.boundary),
                                          std::to_string(element.element),
                                          exactly(p.place.x),
                                          exactly(p.place.y),
                                          exactly(p.pressure),
                                          exactly(p.shear),
                                          exactly(p.normal),
                                          exactly(p.tangential),
                                          exactly(p.gap),
                                          exactly(p.bound),
                                          p.closed ? "1" : "0",
                                          std::to_string(numberOf(p.friction)),
                                          scene.bodies[b].name,
                                          name.empty() ? *element.boundary : name,
                                          exactly(arc.at(element, t))};
        if (more.cells)
          for (std::string& cell : more.cells(b, element, t, p))
            cells.push_back(std::move(cell));
        csv.row(cells);
      }
  }
  return csv.text();
}

std::string boundaryCsv(const Scene& scene, const FieldGrid& grid) {
  Csv csv({"x", "y", "ux", "uy", "tx", "ty", "boundary", "element", "degree", "body"});
  const std::vector<std::string> names = gridBoundaries(scene);
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

std::string bodiesHead() {
  return csvLine({"level", "body", "load_x", "load_y", "load_moment", "contact_x",
                  "contact_y", "contact_moment", "reaction_x", "reaction_y",
                  "reaction_moment", "energy_strain", "step", "motion_x", "motion_y",
                  "rotation"});
}

namespace {

std::string bodyLine(const std::string& name, int level, int step,
                     const std::array<contact::Resultant, 3>& sums, double energy,
                     const contact::RigidMotion& motion) {
  std::vector<std::string> cells = {std::to_string(level), name};
  for (const contact::Resultant& sum : sums)
    for (const double value : {sum.x, sum.y, sum.moment})
      cells.push_back(exactly(value));
  cells.push_back(exactly(energy));
  cells.push_back(std::to_string(step));
  for (const double value : {motion.slide.x, motion.slide.y, motion.turn})
    cells.push_back(exactly(value));
  return csvLine(cells);
}

/// Moments about the origin of the user's coordinates, as those of elastic bodies.
contact::Resultant aboutOrigin(contact::Resultant sum, bem::Vec2 pole) {
  sum.moment += cross(pole, {sum.x, sum.y});
  return sum;
}

}  // namespace

std::string bodiesLines(const Scene& scene, int level, int step,
                        const std::vector<contact::Summary>& bodies,
                        const std::vector<RigidRow>& rigid) {
  std::string lines;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    lines += bodyLine(scene.bodies[b].name, level, step,
                      {bodies[b].load, bodies[b].contact, bodies[b].reaction},
                      bodies[b].energyStrain, bodies[b].motion);
  for (const RigidRow& row : rigid)
    lines +=
        bodyLine(row.name, level, step,
                 {aboutOrigin(row.load, row.pole), aboutOrigin(row.contact, row.pole),
                  aboutOrigin(row.reaction, row.pole)},
                 0, row.motion);
  return lines;
}

}  // namespace epafi::drivers
