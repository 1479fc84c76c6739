#include "drivers/output/BodiesTable.hpp"

#include "drivers/output/Csv.hpp"

#include <array>

namespace epafi::drivers {

std::string bodiesHead() {
  return csvLine({"level", "body", "load_x", "load_y", "load_moment", "contact_x",
                  "contact_y", "contact_moment", "reaction_x", "reaction_y",
                  "reaction_moment", "energy_strain", "step", "motion_x", "motion_y",
                  "rotation", "body_force_x", "body_force_y", "body_moment"});
}

namespace {

std::string bodyLine(const std::string& name, int level, int step,
                     const std::array<contact::Resultant, 3>& sums, double energy,
                     const contact::RigidMotion& motion,
                     const contact::Resultant& inside) {
  std::vector<std::string> cells = {std::to_string(level), name};
  for (const contact::Resultant& sum : sums)
    for (const double value : {sum.x, sum.y, sum.moment})
      cells.push_back(exactly(value));
  cells.push_back(exactly(energy));
  cells.push_back(std::to_string(step));
  for (const double value : {motion.slide.x, motion.slide.y, motion.turn})
    cells.push_back(exactly(value));
  for (const double value : {inside.x, inside.y, inside.moment})
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
                      bodies[b].energyStrain, bodies[b].motion, bodies[b].inside);
  for (const RigidRow& row : rigid)
    lines +=
        bodyLine(row.name, level, step,
                 {aboutOrigin(row.load, row.pole), aboutOrigin(row.contact, row.pole),
                  aboutOrigin(row.reaction, row.pole)},
                 0, row.motion, aboutOrigin(row.inside, row.pole));
  return lines;
}

}  // namespace epafi::drivers
