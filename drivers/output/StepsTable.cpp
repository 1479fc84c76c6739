#include "drivers/output/StepsTable.hpp"

#include "drivers/output/Csv.hpp"

#include <utility>
#include <vector>

namespace epafi::drivers {

namespace {

/// What a member says.
template <auto member>
std::string cell(const StepRow& row) {
  return number(row.*member);
}

struct Column {
  const char* name;
  std::string (*cell)(const StepRow& row);
};

/// Order and names are a contract: add, never rename.
constexpr Column columns[] = {
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
};

/// Of a contact, or of a body without elasticity.
template <class Row>
struct PartColumn {
  const char* name;
  double (*value)(const Row& part);
};

constexpr PartColumn<ContactRow> contactColumns[] = {
    {"force_x", [](const ContactRow& c) { return c.summary.contact.x; }},
    {"force_y", [](const ContactRow& c) { return c.summary.contact.y; }},
    {"force_normal", [](const ContactRow& c) { return c.summary.forceNormal; }},
    {"force_tangential", [](const ContactRow& c) { return c.summary.forceTangential; }},
    {"contact_length", [](const ContactRow& c) { return c.summary.contactLength; }},
    {"slip_length", [](const ContactRow& c) { return c.summary.slipLength; }},
    {"energy_dissipated", [](const ContactRow& c) { return c.dissipated; }},
};

/// Where a body without elasticity is, and what moves or holds it there.
constexpr PartColumn<RigidRow> rigidColumns[] = {
    {"motion_x", [](const RigidRow& r) { return r.motion.slide.x; }},
    {"motion_y", [](const RigidRow& r) { return r.motion.slide.y; }},
    {"rotation", [](const RigidRow& r) { return r.motion.turn; }},
    {"force_x", [](const RigidRow& r) { return r.load.x + r.reaction.x; }},
    {"force_y", [](const RigidRow& r) { return r.load.y + r.reaction.y; }},
    {"moment", [](const RigidRow& r) { return r.load.moment + r.reaction.moment; }},
};

}  // namespace

std::string stepsHead(const StepRow& row) {
  std::vector<std::string> names;
  for (const Column& column : columns)
    names.emplace_back(column.name);
  for (const ContactRow& contact : row.contacts)
    for (const auto& column : contactColumns)
      names.push_back(contact.name + "." + column.name);
  for (const RigidRow& body : row.rigid)
    for (const auto& column : rigidColumns)
      names.push_back(body.name + "." + column.name);
  return csvLine(names);
}

std::string stepsLine(const StepRow& row) {
  std::vector<std::string> cells;
  for (const Column& column : columns)
    cells.push_back(column.cell(row));
  for (const ContactRow& contact : row.contacts)
    for (const auto& column : contactColumns)
      cells.push_back(exactly(column.value(contact)));
  for (const RigidRow& body : row.rigid)
    for (const auto& column : rigidColumns)
      cells.push_back(exactly(column.value(body)));
  return csvLine(cells);
}

}  // namespace epafi::drivers
