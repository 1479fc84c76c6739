#include "drivers/output/HistoryTables.hpp"

#include "drivers/scene/SceneReader.hpp"
#include "drivers/scene/Text.hpp"

#include <algorithm>
#include <cmath>

namespace epafi::drivers {

using contact::Resultant;
using contact::Summary;

// Users rely on order and names of columns: append new ones, never rename.

namespace {

constexpr const char* energyUnit = "stress length²";
constexpr const char* forceUnit = "stress length";
constexpr const char* forceAndMoment = "stress length, stress length²";
constexpr const char* rootOfEnergy = "root of stress length²";

/// Of one contact, in history.csv and steps.csv.
Cells cellsOf(const Summary& s) {
  return {
      {"force_x", s.contact.x,
       "of each contact, on the body that carries its stresses; the name is "
       "`<body>:<contact>` if several contacts have the same name",
       forceUnit},
      {"force_y", s.contact.y},
      {"force_normal", s.forceNormal},
      {"force_tangential", s.forceTangential},
      {"contact_length", s.contactLength, "likewise, as of all contacts", "length"},
      {"slip_length", s.slipLength},
      {"pressure_max", s.peak.value(), "likewise, as in history.csv of all contacts",
       "stress"},
      {"pressure_max_error", s.peak.error()},
      {"pressure_unbounded", s.peak.isUnbounded(), "likewise"},
      {"moment", s.contact.moment, "likewise: moment about the origin", energyUnit},
      {"contact_length_error", s.contactLengthError, "likewise, as of all contacts",
       "length"},
  };
}

const char* statusOf(bool converged) { return converged ? "converged" : "not converged"; }

}  // namespace

Cells cellsOf(const LevelRow& r) {  // NOLINT(readability-function-size): a table
  using adaptivity::Source;
  const Summary& s = r.summary;
  const auto eta = [&](Source source) {
    return std::sqrt(r.squares[static_cast<std::size_t>(source)]);
  };
  const auto seconds = [&](Phase phase) {
    return r.seconds[static_cast<std::size_t>(phase)];
  };
  Cells cells = {
      {"level", r.level, "number of the level, from 0; number of its elements"},
      {"elements", r.elements},
      {"dof_displacement", r.displacements,
       "number of unknown displacements, of unknown contact stresses, and their sum"},
      {"dof_multiplier", r.multipliers},
      {"dof", r.dof()},
      {"dof_density", r.densities,
       "number of unknown tractions on the boundary, which are eliminated"},
      {"degree_min", r.degreeMin, "smallest and largest degree"},
      {"degree_max", r.degreeMax},
      {"size_min", r.sizeMin, "length of the smallest and of the largest element",
       "length"},
      {"size_max", r.sizeMax},
      {"estimate", r.estimate,
       "estimated error in the energy norm ([estimators](theory/estimators.md))",
       rootOfEnergy},
      {"eta_neumann", eta(Source::Neumann),
       "the terms of the estimate: roots of sums of squares", rootOfEnergy},
      {"eta_contact", eta(Source::Contact)},
      {"eta_density", eta(Source::Density)},
      {"eta_complementarity", eta(Source::Complementarity)},
      {"eta_penetration", eta(Source::Penetration)},
      {"eta_tension", eta(Source::Tension)},
      {"eta_bound", eta(Source::Bound)},
      {"eta_slip", eta(Source::Slip)},
      {"energy_strain", s.energyStrain, "strain energy", energyUnit},
      {"energy_load", s.energyLoad,
       "f·u of elastic bodies, body loads included, forces on rigid bodies not: twice "
       "the "
       "work of loads that grow in proportion",
       energyUnit},
      {"energy_friction", r.energyFriction,
       "friction's work so far, Σ λ_t,i Δr_t,i; without a History that of one step from "
       "zero ([load paths](theory/paths.md))",
       energyUnit},
      {"force_normal", s.forceNormal, "∫ λ_n and ∫ λ_t over all contact sides",
       forceUnit},
      {"force_tangential", s.forceTangential},
      {"reaction_x", s.reaction.x,
       "force and moment about the origin of clamps, supports (`Displacement Normal`) "
       "and "
       "fixed motions on the body",
       forceAndMoment},
      {"reaction_y", s.reaction.y},
      {"reaction_moment", s.reaction.moment},
      {"contact_length", s.contactLength,
       "length of the part where λ_n > 0, under Tied of all of it; of the part where "
       "\\|λ_t\\| reaches its bound, also a bound of 0 in contact; 0 without `Friction`",
       "length"},
      {"slip_length", s.slipLength},
      {"newton_iterations", r.report.newtonIterations,
       "number of Newton steps; number of updates of the slip bound, 0 if it does not "
       "depend on the pressure"},
      {"coulomb_iterations", r.report.coulombIterations},
      {"status", statusOf(r.report.converged()),
       "`converged` or `not converged`: also of a level whose forces or whose virtual "
       "work "
       "do not balance"},
      {"seconds_assembly", seconds(Phase::Assembly),
       "CPU seconds of this level, all threads, of the slowest process", "s"},
      {"seconds_factorization", seconds(Phase::Factorization)},
      {"seconds_stabilization", seconds(Phase::Stabilization)},
      {"seconds_newton", seconds(Phase::Newton)},
      {"seconds_estimate", seconds(Phase::Estimate)},
      {"seconds_total", r.secondsTotal,
       "CPU time so far, all threads, without the program's start, files and true "
       "errors; "
       "elapsed time since the first level began",
       "s"},
      {"seconds_wall", r.secondsWall},
      {"memory_mb", r.memory, "peak memory so far of the largest process", "MiB"},
      {"load_x", s.load.x, "force and moment of the loads", forceAndMoment},
      {"load_y", s.load.y},
      {"load_moment", s.load.moment},
      {"contact_x", s.contact.x,
       "force and moment of obstacles and rigid bodies on the elastic bodies; load + "
       "contact + reaction = 0. With several elastic bodies the moments leave the couple "
       "of the shear across their gaps; bodies.csv has the balance of each body",
       forceAndMoment},
      {"contact_y", s.contact.y},
      {"contact_moment", s.contact.moment},
      {"gamma0", r.gamma0, "γ₀ of the stabilisation, as used"},
      {"memory_forecast_mb", r.memoryForecast,
       "memory foretold for this level, all processes", "MiB"},
      {"operators", r.operators,
       "form of the boundary operators: `dense`, `compressed`, or `dense instead` where "
       "compressed ones failed"},
      {"worst_step", r.worstStep,
       "with a History: the step with the largest estimate, and that estimate; column "
       "`estimate` then combines for each element the largest indicators of all steps. "
       "Without a History 0 and `estimate`",
       ", root of stress length²"},
      {"worst_step_estimate", r.worstEstimate},
      {"estimate_relative", r.relativeEstimate,
       "the estimate over the energy norm of the solution, (2 `energy_strain`)^½; on a "
       "path the largest value of all steps, where the norm of a step is taken as at "
       "least "
       "a tenth of the largest norm; `inf` where nothing is strained and the estimate is "
       "not zero, 0 where both are rounding",
       "1"},
      {"energy_interface", r.energyInterface,
       "energy stored in the surfaces of contacts, ∫∫ s φ'(s) ds "
       "([surfaces](theory/surfaces.md)); 0 without a normal law",
       energyUnit},
      {"estimate_contact", r.contactEstimate,
       "the largest estimate of a contact: on the elements where it is closed, their "
       "neighbours and what lies opposite, over the energy norm of the body in it that "
       "stores less, each with the modulus of the softest one; on a path of the largest "
       "of "
       "its steps. 0 without contact, and under `Weights` Paper",
       "1"},
      {"pressure_max", s.peak.value(),
       "the largest `pressure` on elements that resolve it, whose `pressure_error` is at "
       "most 0.3 of their mean pressure, and that error; of other elements where they "
       "press more inside a side, or where there are none that resolve it",
       "stress"},
      {"pressure_max_error", s.peak.error()},
      {"pressure_unbounded", s.peak.isUnbounded(),
       "1 where an element at an end or corner of a side, or opposite to a corner, does "
       "not resolve its pressure and presses more in its mean than `pressure_max`: the "
       "exact pressure has no bound, or "
       "this mesh does not show it; else 0"},
      {"contact_length_error", s.contactLengthError,
       "by how much `contact_length` may be wrong: half of each element in which contact "
       "ends",
       "length"},
  };
  for (const auto& [name, contact] : r.contacts)
    append(cells, cellsOf(contact), name + ".");
  return cells;
}

double energyOf(const Table& history, std::size_t row) {
  return history.number(row, "energy_strain") - history.number(row, "energy_load") +
         history.number(row, "energy_friction") + history.number(row, "energy_interface");
}

Cells cellsOf(const StepRow& r) {  // NOLINT(readability-function-size): a table
  Cells cells = {
      {"level", r.level, "level, step and time of the row"},
      {"step", r.step},
      {"t", r.t},
      {"newton_iterations", r.newtonIterations, "as in history.csv"},
      {"status", statusOf(r.converged)},
      {"energy_strain", r.energyStrain,
       "strain energy; friction's work so far; the same by the trapezoidal rule; work of "
       "external forces, with [body loads](theory/body-loads.md#energies) that of f - "
       "t_p, "
       "what they leave to the boundary, on u - u_p: not that of weight on u; energy "
       "stored by the stabilisation; what remains in the balance of energy ([load "
       "paths](theory/paths.md))",
       energyUnit},
      {"energy_dissipated", r.energyDissipated},
      {"energy_dissipated_trapezoidal", r.energyTrapezoidal},
      {"energy_outside", r.energyOutside},
      {"energy_stabilisation", r.energyStabilisation},
      {"energy_error", r.energyError},
      {"parts", r.parts,
       "number of parts in which the step was solved, more than one where it failed or "
       "under `History->Tolerance`"},
      {"energy_dissipated_error", r.energyDissipatedError,
       "estimated error of friction's work so far, due to the steps in time; 0 without "
       "`History->Tolerance`",
       energyUnit},
      {"energy_stored", r.energyStored,
       "`energy_outside` - `energy_dissipated_trapezoidal` - `energy_worn` - "
       "`energy_error`: strain energy and the energy stored by the stabilisation, the "
       "surfaces and the springs, without [body loads](theory/body-loads.md)",
       energyUnit},
      {"energy_interface", r.energyInterface,
       "energy stored in the surfaces of contacts ([surfaces](theory/surfaces.md))",
       energyUnit},
      {"energy_worn", r.energyWorn,
       "work so far on what has worn off, ∫∫ p dw ([surfaces](theory/surfaces.md), Wear)",
       energyUnit},
      {"cycles", r.cycles,
       "∫ n dt, n the largest `Cycle Jump`: the cycles so far where one takes a unit of "
       "t; "
       "t without wear"},
      {"energy_springs", r.energySprings, "energy stored in the springs of rigid bodies",
       energyUnit},
  };
  for (const auto& [name, contact] : r.contacts) {
    append(cells, cellsOf(contact), name + ".");
    append(cells,
           {{"energy_dissipated", contact.dissipated,
             "likewise: friction's work so far; the area worn off its section",
             "stress length², length²"},
            {"worn_volume", contact.wornVolume}},
           name + ".");
  }
  for (const auto& [name, s] : r.rigid)
    append(cells,
           {{"motion_x", s.motion.slide.x, "of each rigid body, its reference point",
             "length"},
            {"motion_y", s.motion.slide.y},
            {"rotation", s.motion.turn, "likewise, about its reference point", "radian"},
            {"force_x", s.load.x + s.reaction.x,
             "likewise: forces and moment that move or hold it", forceAndMoment},
            {"force_y", s.load.y + s.reaction.y},
            {"moment", s.load.moment + s.reaction.moment}},
           name + ".");
  return cells;
}

std::vector<double> dissipatedOf(const Table& steps, int level) {
  std::vector<double> work;
  for (const std::size_t row : steps.rowsWith("level", level))
    work.push_back(steps.number(row, "energy_dissipated"));
  return work;
}

Cells cellsOf(const StepRow& step, const std::string& body, const Summary& s) {
  return {
      {"level", step.level, "level and body of the row"},
      {"body", body},
      {"load_x", s.load.x,
       "as in history.csv, but contact includes the forces between bodies: load, "
       "contact, "
       "reaction and body force sum to zero",
       forceAndMoment},
      {"load_y", s.load.y},
      {"load_moment", s.load.moment},
      {"contact_x", s.contact.x},
      {"contact_y", s.contact.y},
      {"contact_moment", s.contact.moment},
      {"reaction_x", s.reaction.x},
      {"reaction_y", s.reaction.y},
      {"reaction_moment", s.reaction.moment},
      {"energy_strain", s.energyStrain, "strain energy of the body", energyUnit},
      {"step", step.step, "step of the row, 0 without a History"},
      {"motion_x", s.motion.slide.x,
       "of a rigid body: displacement of its reference point and rotation about it; of "
       "an "
       "elastic body: mean of its displacement",
       "length, radian"},
      {"motion_y", s.motion.slide.y},
      {"rotation", s.motion.turn},
      {"body_force_x", s.inside.x,
       "resultant of the [body loads](theory/body-loads.md), moment about the origin",
       forceAndMoment},
      {"body_force_y", s.inside.y},
      {"body_moment", s.inside.moment},
  };
}

namespace {

/// With moments about the origin of the user's coordinates, as for elastic bodies.
Summary aboutOrigin(Summary summary, bem::Vec2 pole) {
  for (const auto member :
       {&Summary::load, &Summary::contact, &Summary::reaction, &Summary::inside}) {
    Resultant& sum = summary.*member;
    sum.moment += cross(pole, {sum.x, sum.y});
  }
  return summary;
}

/// The rows of a step in bodies.csv, of all bodies.
void addBodies(const SolvedStep& solved, Table& bodies) {
  const Scene& scene = solved.spaces.scene();
  const StepRow& row = solved.row;
  if (!scene.tellsBodies())
    return;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    bodies.add(cellsOf(
        row, scene.bodies[b].name,
        wholeOf(scene.symmetry, *scene.bodies[b].outline, solved.summaries()[b])));
  for (std::size_t k = 0; k < scene.rigid.size(); ++k)
    bodies.add(cellsOf(row, scene.rigid[k].name,
                       aboutOrigin(row.rigid[k].second, scene.rigid[k].pole)));
}

}  // namespace

Table historyTable(const Scene& scene) {
  return Table(cellsOf(BodySpaces(scene, firstMeshes(scene)).levelRow()));
}

Table stepsTable(const BodySpaces& spaces) { return Table(cellsOf(spaces.stepRow())); }

Table bodiesTable() { return Table(cellsOf(StepRow(), "", Summary())); }

Checkpoint Checkpoint::before(const Scene& scene,
                              const std::optional<Checkpoint>& earlier) {
  Checkpoint tables = earlier.value_or(Checkpoint());
  tables.used = usedXml(scene);
  if (!earlier)
    tables.history = historyTable(scene);
  if (!scene.tellsBodies())
    tables.bodies = Table();
  else if (!tables.bodies.hasColumns())
    tables.bodies = bodiesTable();
  return tables;
}

void Checkpoint::addStep(const SolvedStep& step) {
  steps.add(cellsOf(step.row));
  addBodies(step, bodies);
}

void Checkpoint::addLevel(const SolvedLevel& solved, const LevelRow& row) {
  history.add(cellsOf(row));
  if (!solved.level.onPath())
    addBodies(solved.last(), bodies);
}

void Checkpoint::take(const SolvedLevel& solved, const LevelRow& row) {
  level = solved.level;
  secondsTotal = row.secondsTotal;
  secondsWall = row.secondsWall;
}

}  // namespace epafi::drivers
