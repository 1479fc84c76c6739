#include "drivers/output/StepsTable.hpp"

#include "drivers/output/Csv.hpp"
#include "drivers/scene/Text.hpp"

#include <sstream>
#include <utility>

namespace epafi::drivers {

namespace {

template <auto member>
constexpr auto cell = cellOf<StepRow, member>;

/// Order and names are a contract: add, never rename.
constexpr Column<StepRow> columns[] = {
    {"level", cell<&StepRow::level>},
    {"step", cell<&StepRow::step>},
    {"t", cell<&StepRow::t>},
    {"newton_iterations", cell<&StepRow::newtonIterations>},
    {"status",
     [](const StepRow& r) {
       return std::string(r.converged ? "converged" : "not converged");
     }},
    {"energy_strain", cell<&StepRow::energyStrain>},
    {"energy_dissipated", cell<&StepRow::energyDissipated>},
    {"energy_dissipated_trapezoidal", cell<&StepRow::energyTrapezoidal>},
    {"energy_outside", cell<&StepRow::energyOutside>},
    {"energy_stabilisation", cell<&StepRow::energyStabilisation>},
    {"energy_error", cell<&StepRow::energyError>},
    {"parts", cell<&StepRow::parts>},
    {"energy_dissipated_error", cell<&StepRow::energyDissipatedError>},
    {"energy_stored", cell<&StepRow::energyStored>},
    {"energy_interface", cell<&StepRow::energyInterface>},
    {"energy_worn", cell<&StepRow::energyWorn>},
    {"cycles", cell<&StepRow::cycles>},
    {"energy_springs", cell<&StepRow::energySprings>},
};

constexpr Column<ContactRow> contactColumns[] = {
    {"force_x", [](const ContactRow& c) { return number(c.summary.contact.x); }},
    {"force_y", [](const ContactRow& c) { return number(c.summary.contact.y); }},
    {"force_normal", [](const ContactRow& c) { return number(c.summary.forceNormal); }},
    {"force_tangential",
     [](const ContactRow& c) { return number(c.summary.forceTangential); }},
    {"contact_length",
     [](const ContactRow& c) { return number(c.summary.contactLength); }},
    {"slip_length", [](const ContactRow& c) { return number(c.summary.slipLength); }},
    {"energy_dissipated", [](const ContactRow& c) { return number(c.dissipated); }},
    {"worn_volume", [](const ContactRow& c) { return number(c.summary.wornVolume); }},
    {"pressure_max", [](const ContactRow& c) { return number(c.summary.pressureMax); }},
};

/// Where a body without elasticity is, and what moves or holds it there.
constexpr Column<RigidRow> rigidColumns[] = {
    {"motion_x", [](const RigidRow& r) { return number(r.motion.slide.x); }},
    {"motion_y", [](const RigidRow& r) { return number(r.motion.slide.y); }},
    {"rotation", [](const RigidRow& r) { return number(r.motion.turn); }},
    {"force_x", [](const RigidRow& r) { return number(r.load.x + r.reaction.x); }},
    {"force_y", [](const RigidRow& r) { return number(r.load.y + r.reaction.y); }},
    {"moment",
     [](const RigidRow& r) { return number(r.load.moment + r.reaction.moment); }},
};

std::size_t place(const std::string& name) {
  std::size_t at = 0;
  while (name != columns[at].name)
    ++at;
  return at;
}

}  // namespace

std::string stepsHead(const StepRow& row) {
  std::vector<std::string> names;
  addNames(columns, "", names);
  for (const ContactRow& contact : row.contacts)
    addNames(contactColumns, contact.name + ".", names);
  for (const RigidRow& body : row.rigid)
    addNames(rigidColumns, body.name + ".", names);
  return csvLine(names);
}

std::string stepsLine(const StepRow& row) {
  std::vector<std::string> cells;
  addCells(columns, row, cells);
  for (const ContactRow& contact : row.contacts)
    addCells(contactColumns, contact, cells);
  for (const RigidRow& body : row.rigid)
    addCells(rigidColumns, body, cells);
  return csvLine(cells);
}

std::vector<double> dissipatedOf(const std::string& steps, int level) {
  std::vector<double> work;
  std::istringstream lines(steps);
  std::string line;
  std::getline(lines, line);  // the head
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = csvCells(line);
    if (cells.at(place("level")) == std::to_string(level))
      work.push_back(numberIn<double>(cells.at(place("energy_dissipated"))).value());
  }
  return work;
}

}  // namespace epafi::drivers
