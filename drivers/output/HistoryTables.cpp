#include "drivers/output/HistoryTables.hpp"

#include "drivers/scene/SceneReader.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace epafi::drivers {

using contact::Resultant;
using contact::Summary;

// Users rely on order and names of columns: append new ones, never rename.

namespace {

/// Of one contact, in history.csv and steps.csv.
CsvRow cellsOf(const Summary& s) {
  return {{"force_x", number(s.contact.x)},
          {"force_y", number(s.contact.y)},
          {"force_normal", number(s.forceNormal)},
          {"force_tangential", number(s.forceTangential)},
          {"contact_length", number(s.contactLength)},
          {"slip_length", number(s.slipLength)},
          {"pressure_max", number(s.peak.value())},
          {"pressure_max_error", number(s.peak.error())},
          {"pressure_unbounded", number(s.peak.isUnbounded())},
          {"moment", number(s.contact.moment)}};
}

}  // namespace

CsvRow cellsOf(const LevelRow& r) {  // NOLINT(readability-function-size): a table
  using adaptivity::Source;
  const Summary& s = r.summary;
  const auto eta = [&](Source source) {
    return number(std::sqrt(r.squares[static_cast<std::size_t>(source)]));
  };
  const auto seconds = [&](Phase phase) {
    return number(r.seconds[static_cast<std::size_t>(phase)]);
  };
  CsvRow cells = {
      {"level", number(r.level)},
      {"elements", number(r.elements)},
      {"dof_displacement", number(r.displacements)},
      {"dof_multiplier", number(r.multipliers)},
      {"dof", number(r.dof())},
      {"dof_density", number(r.densities)},
      {"degree_min", number(r.degreeMin)},
      {"degree_max", number(r.degreeMax)},
      {"size_min", number(r.sizeMin)},
      {"size_max", number(r.sizeMax)},
      {"estimate", number(r.estimate)},
      {"eta_neumann", eta(Source::Neumann)},
      {"eta_contact", eta(Source::Contact)},
      {"eta_density", eta(Source::Density)},
      {"eta_complementarity", eta(Source::Complementarity)},
      {"eta_penetration", eta(Source::Penetration)},
      {"eta_tension", eta(Source::Tension)},
      {"eta_bound", eta(Source::Bound)},
      {"eta_slip", eta(Source::Slip)},
      {"energy_strain", number(s.energyStrain)},
      {"energy_load", number(s.energyLoad)},
      {"energy_friction", number(r.energyFriction)},
      {"force_normal", number(s.forceNormal)},
      {"force_tangential", number(s.forceTangential)},
      {"reaction_x", number(s.reaction.x)},
      {"reaction_y", number(s.reaction.y)},
      {"reaction_moment", number(s.reaction.moment)},
      {"contact_length", number(s.contactLength)},
      {"slip_length", number(s.slipLength)},
      {"newton_iterations", number(r.report.newtonIterations)},
      {"coulomb_iterations", number(r.report.coulombIterations)},
      {"status", r.report.converged() ? "converged" : "not converged"},
      {"seconds_assembly", seconds(Phase::Assembly)},
      {"seconds_factorization", seconds(Phase::Factorization)},
      {"seconds_stabilization", seconds(Phase::Stabilization)},
      {"seconds_newton", seconds(Phase::Newton)},
      {"seconds_estimate", seconds(Phase::Estimate)},
      {"seconds_total", number(r.secondsTotal)},
      {"seconds_wall", number(r.secondsWall)},
      {"memory_mb", number(r.memory)},
      {"load_x", number(s.load.x)},
      {"load_y", number(s.load.y)},
      {"load_moment", number(s.load.moment)},
      {"contact_x", number(s.contact.x)},
      {"contact_y", number(s.contact.y)},
      {"contact_moment", number(s.contact.moment)},
      {"gamma0", number(r.gamma0)},
      {"memory_forecast_mb", number(r.memoryForecast)},
      {"operators", r.operators},
      {"worst_step", number(r.worstStep)},
      {"worst_step_estimate", number(r.worstEstimate)},
      {"estimate_relative", number(r.relativeEstimate)},
      {"energy_interface", number(r.energyInterface)},
      {"estimate_contact", number(r.contactEstimate)},
      {"pressure_max", number(s.peak.value())},
      {"pressure_max_error", number(s.peak.error())},
      {"pressure_unbounded", number(s.peak.isUnbounded())},
  };
  for (const auto& [name, contact] : r.contacts)
    append(cells, cellsOf(contact), name + ".");
  return cells;
}

double energyOf(const CsvRow& row) {
  return valueOf(row, "energy_strain") - valueOf(row, "energy_load") +
         valueOf(row, "energy_friction") + valueOf(row, "energy_interface");
}

CsvRow cellsOf(const StepRow& r) {
  CsvRow cells = {
      {"level", number(r.level)},
      {"step", number(r.step)},
      {"t", number(r.t)},
      {"newton_iterations", number(r.newtonIterations)},
      {"status", r.converged ? "converged" : "not converged"},
      {"energy_strain", number(r.energyStrain)},
      {"energy_dissipated", number(r.energyDissipated)},
      {"energy_dissipated_trapezoidal", number(r.energyTrapezoidal)},
      {"energy_outside", number(r.energyOutside)},
      {"energy_stabilisation", number(r.energyStabilisation)},
      {"energy_error", number(r.energyError)},
      {"parts", number(r.parts)},
      {"energy_dissipated_error", number(r.energyDissipatedError)},
      {"energy_stored", number(r.energyStored)},
      {"energy_interface", number(r.energyInterface)},
      {"energy_worn", number(r.energyWorn)},
      {"cycles", number(r.cycles)},
      {"energy_springs", number(r.energySprings)},
  };
  for (const auto& [name, contact] : r.contacts) {
    append(cells, cellsOf(contact), name + ".");
    append(cells,
           {{"energy_dissipated", number(contact.dissipated)},
            {"worn_volume", number(contact.wornVolume)}},
           name + ".");
  }
  for (const auto& [name, s] : r.rigid)  // the forces that move or hold it
    append(cells,
           {{"motion_x", number(s.motion.slide.x)},
            {"motion_y", number(s.motion.slide.y)},
            {"rotation", number(s.motion.turn)},
            {"force_x", number(s.load.x + s.reaction.x)},
            {"force_y", number(s.load.y + s.reaction.y)},
            {"moment", number(s.load.moment + s.reaction.moment)}},
           name + ".");
  return cells;
}

std::vector<double> dissipatedOf(const std::string& steps, int level) {
  std::vector<double> work;
  for (const CsvRow& row : rowsOf(steps))
    if (valueOf(row, "level") == level)
      work.push_back(valueOf(row, "energy_dissipated"));
  return work;
}

namespace {

CsvRow bodyCells(const StepRow& step, const std::string& body, const Summary& s) {
  return {
      {"level", number(step.level)},
      {"body", body},
      {"load_x", number(s.load.x)},
      {"load_y", number(s.load.y)},
      {"load_moment", number(s.load.moment)},
      {"contact_x", number(s.contact.x)},
      {"contact_y", number(s.contact.y)},
      {"contact_moment", number(s.contact.moment)},
      {"reaction_x", number(s.reaction.x)},
      {"reaction_y", number(s.reaction.y)},
      {"reaction_moment", number(s.reaction.moment)},
      {"energy_strain", number(s.energyStrain)},
      {"step", number(step.step)},
      {"motion_x", number(s.motion.slide.x)},
      {"motion_y", number(s.motion.slide.y)},
      {"rotation", number(s.motion.turn)},
      {"body_force_x", number(s.inside.x)},
      {"body_force_y", number(s.inside.y)},
      {"body_moment", number(s.inside.moment)},
  };
}

/// With moments about the origin of the user's coordinates, as for elastic bodies.
Summary aboutOrigin(Summary summary, bem::Vec2 pole) {
  for (const auto member :
       {&Summary::load, &Summary::contact, &Summary::reaction, &Summary::inside}) {
    Resultant& sum = summary.*member;
    sum.moment += cross(pole, {sum.x, sum.y});
  }
  return summary;
}

/// The lines of a step in bodies.csv, of all bodies.
std::string bodiesLines(const SolvedStep& solved) {
  const Scene& scene = solved.spaces.scene();
  const StepRow& row = solved.row;
  if (!scene.tellsBodies())
    return "";
  std::string lines;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    lines += lineOf(bodyCells(
        row, scene.bodies[b].name,
        wholeOf(scene.symmetry, *scene.bodies[b].outline, solved.summaries()[b])));
  for (std::size_t k = 0; k < scene.rigid.size(); ++k)
    lines += lineOf(bodyCells(row, scene.rigid[k].name,
                              aboutOrigin(row.rigid[k].second, scene.rigid[k].pole)));
  return lines;
}

}  // namespace

std::string historyHead(const Scene& scene) {
  return headOf(cellsOf(BodySpaces(scene, firstMeshes(scene)).levelRow()));
}

std::string bodiesHead() { return headOf(bodyCells({}, "", {})); }

namespace {

/// With two digits behind the point.
std::string fixed(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << value;
  return text.str();
}

/// A part of the energy norm, with three digits.
std::string percent(double part) {
  std::ostringstream text;
  text << std::setprecision(3) << 100 * part;
  return text.str();
}

/// Calls add(name, width, value, digits) for each column of the table that a run prints.
template <class Add>
void forEachColumn(const LevelRow& r, const Add& add) {
  const bool isUniform = r.degreeMin == r.degreeMax;
  const bool isCoulomb = r.report.coulombIterations != 0;
  const auto two = [](int a, const char* between, int b, bool both) {
    return both ? bem::message(a, between, b) : bem::message(a);
  };
  add("level", 5, r.level, 0);
  add("elements", 9, r.elements, 0);
  add("dof", 7, r.dof(), 0);
  add("degree", 7, two(r.degreeMin, "-", r.degreeMax, !isUniform), 0);
  add("steps", 9,
      two(r.report.newtonIterations, "/", r.report.coulombIterations, isCoulomb), 0);
  add("estimate", 11, r.estimate, 4);
  add("error %", 9, percent(r.relativeEstimate), 0);
  add("strain energy", 16, r.summary.energyStrain, 9);
  add("load energy", 16, r.summary.energyLoad, 9);
  add("friction", 13, r.energyFriction, 6);
  add("normal force", 15, r.summary.forceNormal, 8);
  add("CPU s", 9, fixed(r.secondsTotal), 0);
  add("wall s", 9, fixed(r.secondsWall), 0);
}

constexpr std::size_t contactsShown = 3;

/// Those with the largest forces, if there are more than are shown.
template <class Contacts>
Contacts largest(Contacts contacts) {
  if (contacts.size() <= contactsShown)
    return contacts;
  const auto force = [](const auto& contact) {
    return std::hypot(contact.second.forceNormal, contact.second.forceTangential);
  };
  std::stable_sort(contacts.begin(), contacts.end(),
                   [&](const auto& a, const auto& b) { return force(a) > force(b); });
  contacts.resize(contactsShown);
  return contacts;
}

}  // namespace

std::string tableHead() {
  std::ostringstream line;
  forEachColumn({}, [&](const char* name, int width, const auto&, int) {
    line << ' ' << std::setw(width - 1) << name;
  });
  line << '\n';
  return line.str();
}

std::string tableLine(const LevelRow& row) {
  std::ostringstream line;
  forEachColumn(row, [&](const char*, int width, const auto& value, int digits) {
    line << ' ' << std::setw(width - 1) << std::setprecision(digits) << value;
  });
  line << (row.report.converged() ? "\n" : "  not converged\n");
  return line.str();
}

std::string tableLine(const StepRow& row) {
  std::ostringstream line;
  line << "        step " << std::setw(4) << row.step << "  t = " << std::left
       << std::setw(10) << row.t << std::right << std::setw(16)
       << counted(row.newtonIterations, "Newton step", "Newton steps")
       << ", friction's work " << row.energyDissipated << std::setprecision(5);
  for (const auto& [name, contact] : largest(row.contacts))
    line << (name.empty() ? ";" : "; " + name) << " normal force " << contact.forceNormal
         << ", shear " << contact.forceTangential;
  if (row.contacts.size() > contactsShown)
    line << "; " << row.contacts.size() - contactsShown << " more in steps.csv";
  for (const auto& [name, summary] : row.rigid)
    line << "; " << name << " at (" << summary.motion.slide.x << ", "
         << summary.motion.slide.y << "), turned by " << summary.motion.turn;
  if (row.parts > 1)
    line << "; halved: " << row.parts << " parts";
  line << (row.converged ? "\n" : "  not converged\n");
  return line.str();
}

std::string notesOn(const LevelRow& row, double gamma0) {
  std::ostringstream text;
  text << std::setprecision(4);
  const std::string level = bem::message("level ", row.level);
  if (row.gamma0 != 0 && row.gamma0 != gamma0)
    text << "        Gamma0 = " << row.gamma0 << " on " << level << ": the default, "
         << gamma0 << ", would make its stiffness indefinite\n";
  if (!row.note.empty())
    text << "        " << level << ": " << row.note << '\n';
  if (row.worstStep != 0)
    text << "        " << level << ": the largest error is that of step " << row.worstStep
         << ", estimated " << row.worstEstimate << '\n';
  return text.str();
}

std::string pressureLine(const SolvedLevel& level) {
  contact::PeakPressure peak = level.row.summary.peak;
  for (const auto& step : level.steps)
    for (const auto& [name, summary] : step->row.contacts)
      peak.add(summary.peak);
  if (peak.value() == 0)
    return "";
  std::ostringstream text;
  text << std::setprecision(4) << "pressure up to " << peak.value()
       << " where elements resolve it, with an error of " << peak.error()
       << (peak.isUnbounded() ? "; unbounded at an end of a side" : "") << '\n';
  return text.str();
}

std::string timeSummary(const PhaseTimer& timer) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "time    " << cpuSeconds()
       << " s of CPU, " << timer.wallSeconds() << " s:";
  for (int i = 0; i < phaseCount; ++i) {
    const auto phase = static_cast<Phase>(i);
    text << (i == 0 ? " " : ", ") << nameOf(phase) << ' ' << timer.totalSeconds(phase);
  }
  text << "\nmemory  " << std::setprecision(0) << peakMemory() << " MiB at most\n";
  return text.str();
}

Checkpoint Checkpoint::before(const Scene& scene,
                              const std::optional<Checkpoint>& earlier) {
  Checkpoint tables = earlier.value_or(Checkpoint());
  tables.used = usedXml(scene);
  if (!earlier)
    tables.history = historyHead(scene);
  if (!scene.tellsBodies())
    tables.bodies.clear();
  else if (tables.bodies.empty())
    tables.bodies = bodiesHead();
  return tables;
}

void Checkpoint::addStep(const SolvedStep& step) {
  addRow(cellsOf(step.row), steps);
  bodies += bodiesLines(step);
}

void Checkpoint::addLevel(const SolvedLevel& solved, const LevelRow& row) {
  addRow(cellsOf(row), history);
  if (!solved.level.onPath())
    bodies += bodiesLines(solved.last());
}

void Checkpoint::take(const SolvedLevel& solved, const LevelRow& row) {
  level = solved.level;
  secondsTotal = row.secondsTotal;
  secondsWall = row.secondsWall;
}

}  // namespace epafi::drivers
