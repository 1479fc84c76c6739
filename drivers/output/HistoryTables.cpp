#include "drivers/output/HistoryTables.hpp"

#include "drivers/output/Csv.hpp"
#include "drivers/scene/SceneReader.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace epafi::drivers {

// Users rely on order and names of columns: append new ones, never rename.
namespace {

using adaptivity::Source;
using contact::Resultant;
using contact::Summary;

template <auto... members>
constexpr auto cell = cellOf<LevelRow, members...>;

template <auto... members>
constexpr auto sum = cell<&LevelRow::summary, members...>;

template <Source source>
std::string eta(const LevelRow& row) {
  return number(std::sqrt(row.squares[static_cast<std::size_t>(source)]));
}

template <Phase phase>
std::string seconds(const LevelRow& row) {
  return number(row.seconds[static_cast<std::size_t>(phase)]);
}

constexpr Column<LevelRow> levelColumns[] = {
    {"level", cell<&LevelRow::level>},
    {"elements", cell<&LevelRow::elements>},
    {"dof_displacement", cell<&LevelRow::displacements>},
    {"dof_multiplier", cell<&LevelRow::multipliers>},
    {"dof", [](const LevelRow& r) { return number(r.dof()); }},
    {"dof_density", cell<&LevelRow::densities>},
    {"degree_min", cell<&LevelRow::degreeMin>},
    {"degree_max", cell<&LevelRow::degreeMax>},
    {"size_min", cell<&LevelRow::sizeMin>},
    {"size_max", cell<&LevelRow::sizeMax>},
    {"estimate", cell<&LevelRow::estimate>},
    {"eta_neumann", eta<Source::Neumann>},
    {"eta_contact", eta<Source::Contact>},
    {"eta_density", eta<Source::Density>},
    {"eta_complementarity", eta<Source::Complementarity>},
    {"eta_penetration", eta<Source::Penetration>},
    {"eta_tension", eta<Source::Tension>},
    {"eta_bound", eta<Source::Bound>},
    {"eta_slip", eta<Source::Slip>},
    {"energy_strain", sum<&Summary::energyStrain>},
    {"energy_load", sum<&Summary::energyLoad>},
    {"energy_friction", cell<&LevelRow::energyFriction>},
    {"force_normal", sum<&Summary::forceNormal>},
    {"force_tangential", sum<&Summary::forceTangential>},
    {"reaction_x", sum<&Summary::reaction, &Resultant::x>},
    {"reaction_y", sum<&Summary::reaction, &Resultant::y>},
    {"reaction_moment", sum<&Summary::reaction, &Resultant::moment>},
    {"contact_length", sum<&Summary::contactLength>},
    {"slip_length", sum<&Summary::slipLength>},
    {"newton_iterations", cell<&LevelRow::report, &contact::Report::newtonIterations>},
    {"coulomb_iterations", cell<&LevelRow::report, &contact::Report::coulombIterations>},
    {"status",
     [](const LevelRow& r) {
       return std::string(
           r.report.status == contact::Status::Converged ? "converged" : "not converged");
     }},
    {"seconds_assembly", seconds<Phase::Assembly>},
    {"seconds_factorization", seconds<Phase::Factorization>},
    {"seconds_stabilization", seconds<Phase::Stabilization>},
    {"seconds_newton", seconds<Phase::Newton>},
    {"seconds_estimate", seconds<Phase::Estimate>},
    {"seconds_total", cell<&LevelRow::secondsTotal>},
    {"seconds_wall", cell<&LevelRow::secondsWall>},
    {"memory_mb", cell<&LevelRow::memory>},
    {"load_x", sum<&Summary::load, &Resultant::x>},
    {"load_y", sum<&Summary::load, &Resultant::y>},
    {"load_moment", sum<&Summary::load, &Resultant::moment>},
    {"contact_x", sum<&Summary::contact, &Resultant::x>},
    {"contact_y", sum<&Summary::contact, &Resultant::y>},
    {"contact_moment", sum<&Summary::contact, &Resultant::moment>},
    {"gamma0", cell<&LevelRow::gamma0>},
    {"memory_forecast_mb", cell<&LevelRow::memoryForecast>},
    {"operators", [](const LevelRow& r) { return r.operators; }},
    {"worst_step", cell<&LevelRow::worstStep>},
    {"worst_step_estimate", cell<&LevelRow::worstEstimate>},
    {"estimate_relative", cell<&LevelRow::relativeEstimate>},
    {"energy_interface", cell<&LevelRow::energyInterface>},
};

template <auto member>
constexpr auto step = cellOf<StepRow, member>;

constexpr Column<StepRow> stepColumns[] = {
    {"level", step<&StepRow::level>},
    {"step", step<&StepRow::step>},
    {"t", step<&StepRow::t>},
    {"newton_iterations", step<&StepRow::newtonIterations>},
    {"status",
     [](const StepRow& r) {
       return std::string(r.converged ? "converged" : "not converged");
     }},
    {"energy_strain", step<&StepRow::energyStrain>},
    {"energy_dissipated", step<&StepRow::energyDissipated>},
    {"energy_dissipated_trapezoidal", step<&StepRow::energyTrapezoidal>},
    {"energy_outside", step<&StepRow::energyOutside>},
    {"energy_stabilisation", step<&StepRow::energyStabilisation>},
    {"energy_error", step<&StepRow::energyError>},
    {"parts", step<&StepRow::parts>},
    {"energy_dissipated_error", step<&StepRow::energyDissipatedError>},
    {"energy_stored", step<&StepRow::energyStored>},
    {"energy_interface", step<&StepRow::energyInterface>},
    {"energy_worn", step<&StepRow::energyWorn>},
    {"cycles", step<&StepRow::cycles>},
    {"energy_springs", step<&StepRow::energySprings>},
};

template <auto... members>
constexpr auto ofPart = cellOf<PartRow, &PartRow::summary, members...>;

constexpr Column<PartRow> contactColumns[] = {
    {"force_x", ofPart<&Summary::contact, &Resultant::x>},
    {"force_y", ofPart<&Summary::contact, &Resultant::y>},
    {"force_normal", ofPart<&Summary::forceNormal>},
    {"force_tangential", ofPart<&Summary::forceTangential>},
    {"contact_length", ofPart<&Summary::contactLength>},
    {"slip_length", ofPart<&Summary::slipLength>},
    {"energy_dissipated", cellOf<PartRow, &PartRow::dissipated>},
    {"worn_volume", ofPart<&Summary::wornVolume>},
    {"pressure_max", ofPart<&Summary::pressureMax>},
};

/// Motion of a rigid body, and the forces that move or hold it.
constexpr Column<PartRow> rigidColumns[] = {
    {"motion_x", ofPart<&Summary::motion, &contact::RigidMotion::slide, &bem::Vec2::x>},
    {"motion_y", ofPart<&Summary::motion, &contact::RigidMotion::slide, &bem::Vec2::y>},
    {"rotation", ofPart<&Summary::motion, &contact::RigidMotion::turn>},
    {"force_x",
     [](const PartRow& r) { return number(r.summary.load.x + r.summary.reaction.x); }},
    {"force_y",
     [](const PartRow& r) { return number(r.summary.load.y + r.summary.reaction.y); }},
    {"moment",
     [](const PartRow& r) {
       return number(r.summary.load.moment + r.summary.reaction.moment);
     }},
};

/// A row of bodies.csv.
struct BodyRow {
  int level;
  int step;
  std::string name;
  Summary summary;
};

template <auto... members>
constexpr auto body = cellOf<BodyRow, &BodyRow::summary, members...>;

constexpr Column<BodyRow> bodyColumns[] = {
    {"level", cellOf<BodyRow, &BodyRow::level>},
    {"body", [](const BodyRow& r) { return r.name; }},
    {"load_x", body<&Summary::load, &Resultant::x>},
    {"load_y", body<&Summary::load, &Resultant::y>},
    {"load_moment", body<&Summary::load, &Resultant::moment>},
    {"contact_x", body<&Summary::contact, &Resultant::x>},
    {"contact_y", body<&Summary::contact, &Resultant::y>},
    {"contact_moment", body<&Summary::contact, &Resultant::moment>},
    {"reaction_x", body<&Summary::reaction, &Resultant::x>},
    {"reaction_y", body<&Summary::reaction, &Resultant::y>},
    {"reaction_moment", body<&Summary::reaction, &Resultant::moment>},
    {"energy_strain", body<&Summary::energyStrain>},
    {"step", cellOf<BodyRow, &BodyRow::step>},
    {"motion_x", body<&Summary::motion, &contact::RigidMotion::slide, &bem::Vec2::x>},
    {"motion_y", body<&Summary::motion, &contact::RigidMotion::slide, &bem::Vec2::y>},
    {"rotation", body<&Summary::motion, &contact::RigidMotion::turn>},
    {"body_force_x", body<&Summary::inside, &Resultant::x>},
    {"body_force_y", body<&Summary::inside, &Resultant::y>},
    {"body_moment", body<&Summary::inside, &Resultant::moment>},
};

/// With moments about the origin of the user's coordinates, as for elastic bodies.
Summary aboutOrigin(Summary summary, bem::Vec2 pole) {
  for (const auto member :
       {&Summary::load, &Summary::contact, &Summary::reaction, &Summary::inside}) {
    Resultant& sum = summary.*member;
    sum.moment += cross(pole, {sum.x, sum.y});
  }
  return summary;
}

/// Index of a column.  \pre a column has this name
template <class Row, std::size_t count>
std::size_t placeOf(const std::string& name, const Column<Row> (&columns)[count]) {
  const auto at =
      std::find_if(std::begin(columns), std::end(columns),
                   [&](const Column<Row>& column) { return column.name == name; });
  return static_cast<std::size_t>(at - columns);
}

std::string stepsLine(const StepRow& row) {
  std::vector<std::string> cells;
  addCells(stepColumns, row, cells);
  for (const PartRow& contact : row.contacts)
    addCells(contactColumns, contact, cells);
  for (const PartRow& body : row.rigid)
    addCells(rigidColumns, body, cells);
  return csvLine(cells);
}

/// The lines of a step in bodies.csv, of all bodies.
std::string bodiesLines(const SolvedStep& solved) {
  const Scene& scene = solved.spaces.scene();
  const StepRow& row = solved.row;
  if (!scene.tellsBodies())
    return "";
  std::string lines;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    lines += csvRow(bodyColumns, {row.level, row.step, scene.bodies[b].name,
                                  wholeOf(scene.symmetry, *scene.bodies[b].outline,
                                          solved.summaries()[b])});
  for (std::size_t k = 0; k < scene.rigid.size(); ++k)
    lines +=
        csvRow(bodyColumns, {row.level, row.step, scene.rigid[k].name,
                             aboutOrigin(row.rigid[k].summary, scene.rigid[k].pole)});
  return lines;
}

}  // namespace

std::string bodiesHead() { return csvHead(bodyColumns); }

std::vector<std::string> historyColumns() {
  std::vector<std::string> names;
  addNames(levelColumns, "", names);
  return names;
}

std::vector<std::string> historyCells(const LevelRow& row) {
  std::vector<std::string> cells;
  addCells(levelColumns, row, cells);
  return cells;
}

std::size_t historyColumn(const std::string& name) { return placeOf(name, levelColumns); }

std::string historyHead() { return csvHead(levelColumns); }

std::vector<std::string> lastCells(const std::string& history) {
  const std::size_t begin = history.rfind('\n', history.size() - 2) + 1;
  return csvCells(history.substr(begin));
}

double valueOf(const std::vector<std::string>& cells, const std::string& name) {
  return numberIn<double>(cells.at(historyColumn(name))).value();
}

double energyOf(const std::vector<std::string>& cells) {
  return valueOf(cells, "energy_strain") - valueOf(cells, "energy_load") +
         valueOf(cells, "energy_friction") + valueOf(cells, "energy_interface");
}

std::string stepsHead(const StepRow& row) {
  std::vector<std::string> names;
  addNames(stepColumns, "", names);
  for (const PartRow& contact : row.contacts)
    addNames(contactColumns, contact.name + ".", names);
  for (const PartRow& body : row.rigid)
    addNames(rigidColumns, body.name + ".", names);
  return csvLine(names);
}

std::vector<double> dissipatedOf(const std::string& steps, int level) {
  std::vector<double> work;
  std::istringstream lines(steps);
  std::string line;
  std::getline(lines, line);  // the head
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = csvCells(line);
    if (cells.at(placeOf("level", stepColumns)) == std::to_string(level))
      work.push_back(
          numberIn<double>(cells.at(placeOf("energy_dissipated", stepColumns))).value());
  }
  return work;
}

Checkpoint Checkpoint::before(const Scene& scene,
                              const std::optional<Checkpoint>& earlier) {
  Checkpoint tables = earlier.value_or(Checkpoint());
  tables.used = usedXml(scene);
  if (!earlier)
    tables.history = historyHead();
  if (!scene.tellsBodies())
    tables.bodies.clear();
  else if (tables.bodies.empty())
    tables.bodies = bodiesHead();
  return tables;
}

void Checkpoint::addStep(const SolvedStep& step) {
  steps += (steps.empty() ? stepsHead(step.row) : "") + stepsLine(step.row);
  bodies += bodiesLines(step);
}

void Checkpoint::addLevel(const SolvedLevel& solved, const LevelRow& row) {
  history += csvLine(historyCells(row));
  if (!solved.level.onPath())
    bodies += bodiesLines(solved.last());
}

void Checkpoint::take(const SolvedLevel& solved, const LevelRow& row) {
  level = solved.level;
  secondsTotal = row.secondsTotal;
  secondsWall = row.secondsWall;
}

}  // namespace epafi::drivers
