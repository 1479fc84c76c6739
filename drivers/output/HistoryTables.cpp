#include "drivers/output/HistoryTables.hpp"

#include "drivers/scene/SceneReader.hpp"

#include <cmath>

namespace epafi::drivers {

using contact::Resultant;
using contact::Summary;

// Users rely on order and names of columns: append new ones, never rename.

CsvRow cellsOf(const LevelRow& r) {  // NOLINT(readability-function-size): a table
  using adaptivity::Source;
  const Summary& s = r.summary;
  const auto eta = [&](Source source) {
    return number(std::sqrt(r.squares[static_cast<std::size_t>(source)]));
  };
  const auto seconds = [&](Phase phase) {
    return number(r.seconds[static_cast<std::size_t>(phase)]);
  };
  return {
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
  };
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
  for (const auto& [name, s] : r.contacts)
    append(cells,
           {
               {"force_x", number(s.contact.x)},
               {"force_y", number(s.contact.y)},
               {"force_normal", number(s.forceNormal)},
               {"force_tangential", number(s.forceTangential)},
               {"contact_length", number(s.contactLength)},
               {"slip_length", number(s.slipLength)},
               {"energy_dissipated", number(s.dissipated)},
               {"worn_volume", number(s.wornVolume)},
               {"pressure_max", number(s.pressureMax)},
           },
           name + ".");
  for (const auto& [name, s] : r.rigid)  // the forces that move or hold it
    append(cells,
           {
               {"motion_x", number(s.motion.slide.x)},
               {"motion_y", number(s.motion.slide.y)},
               {"rotation", number(s.motion.turn)},
               {"force_x", number(s.load.x + s.reaction.x)},
               {"force_y", number(s.load.y + s.reaction.y)},
               {"moment", number(s.load.moment + s.reaction.moment)},
           },
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

std::string bodiesHead() { return headOf(bodyCells({}, "", {})); }

Checkpoint Checkpoint::before(const Scene& scene,
                              const std::optional<Checkpoint>& earlier) {
  Checkpoint tables = earlier.value_or(Checkpoint());
  tables.used = usedXml(scene);
  if (!earlier)
    tables.history = headOf(cellsOf(LevelRow()));
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
