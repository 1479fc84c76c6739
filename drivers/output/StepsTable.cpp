#include "drivers/output/StepsTable.hpp"

#include "drivers/output/Csv.hpp"

#include <utility>
#include <vector>

namespace epafi::drivers {

namespace {

struct Column {
  const char* name;
  std::string (*cell)(const StepRow& row);
};

/// Order and names are a contract: add, never rename.
constexpr Column columns[] = {
    {"level", [](const StepRow& r) { return std::to_string(r.level); }},
    {"step", [](const StepRow& r) { return std::to_string(r.step); }},
    {"t", [](const StepRow& r) { return exactly(r.t); }},
    {"newton_iterations",
     [](const StepRow& r) { return std::to_string(r.newtonIterations); }},
    {"status",
     [](const StepRow& r) {
       return std::string(r.converged ? "converged" : "not converged");
     }},
    {"energy_strain", [](const StepRow& r) { return exactly(r.energyStrain); }},
    {"energy_dissipated", [](const StepRow& r) { return exactly(r.energyDissipated); }},
    {"energy_dissipated_trapezoidal",
     [](const StepRow& r) { return exactly(r.energyTrapezoidal); }},
    {"energy_outside", [](const StepRow& r) { return exactly(r.energyOutside); }},
    {"energy_stabilisation",
     [](const StepRow& r) { return exactly(r.energyStabilisation); }},
    {"energy_error", [](const StepRow& r) { return exactly(r.energyError); }},
    {"parts", [](const StepRow& r) { return std::to_string(r.parts); }},
};

struct ContactColumn {
  const char* name;
  double (*value)(const ContactRow& contact);
};

constexpr ContactColumn contactColumns[] = {
    {"force_x", [](const ContactRow& c) { return c.summary.contact.x; }},
    {"force_y", [](const ContactRow& c) { return c.summary.contact.y; }},
    {"force_normal", [](const ContactRow& c) { return c.summary.forceNormal; }},
    {"force_tangential", [](const ContactRow& c) { return c.summary.forceTangential; }},
    {"contact_length", [](const ContactRow& c) { return c.summary.contactLength; }},
    {"slip_length", [](const ContactRow& c) { return c.summary.slipLength; }},
    {"energy_dissipated", [](const ContactRow& c) { return c.dissipated; }},
};

/// A body without elasticity: where it is, and what moves or holds it there.
struct RigidColumn {
  const char* name;
  double (*value)(const RigidRow& body);
};

constexpr RigidColumn rigidColumns[] = {
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
    for (const ContactColumn& column : contactColumns)
      names.push_back(contact.name + "." + column.name);
  for (const RigidRow& body : row.rigid)
    for (const RigidColumn& column : rigidColumns)
      names.push_back(body.name + "." + column.name);
  return csvLine(names);
}

std::string stepsLine(const StepRow& row) {
  std::vector<std::string> cells;
  for (const Column& column : columns)
    cells.push_back(column.cell(row));
  for (const ContactRow& contact : row.contacts)
    for (const ContactColumn& column : contactColumns)
      cells.push_back(exactly(column.value(contact)));
  for (const RigidRow& body : row.rigid)
    for (const RigidColumn& column : rigidColumns)
      cells.push_back(exactly(column.value(body)));
  return csvLine(cells);
}

}  // namespace epafi::drivers
