#include "drivers/output/History.hpp"

#include "drivers/output/Csv.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace epafi::drivers {

namespace {

std::string number(bem::Index value) { return std::to_string(value); }
std::string number(int value) { return std::to_string(value); }
std::string number(double value) { return exactly(value); }

template <adaptivity::Source source>
double contribution(const LevelRow& row) {
  return std::sqrt(row.squares[static_cast<std::size_t>(source)]);
}

struct Column {
  const char* name;
  std::string (*cell)(const LevelRow& row);
};

/// Order and names are a contract: add, never rename.
constexpr Column columns[] = {
    {"level", [](const LevelRow& r) { return number(r.level); }},
    {"elements", [](const LevelRow& r) { return number(r.size.elements); }},
    {"dof_displacement", [](const LevelRow& r) { return number(r.size.displacements); }},
    {"dof_multiplier", [](const LevelRow& r) { return number(r.size.multipliers); }},
    {"dof", [](const LevelRow& r) { return number(r.size.dof()); }},
    {"dof_density", [](const LevelRow& r) { return number(r.size.densities); }},
    {"degree_min", [](const LevelRow& r) { return number(r.size.degreeMin); }},
    {"degree_max", [](const LevelRow& r) { return number(r.size.degreeMax); }},
    {"size_min", [](const LevelRow& r) { return number(r.size.sizeMin); }},
    {"size_max", [](const LevelRow& r) { return number(r.size.sizeMax); }},
    {"estimate", [](const LevelRow& r) { return number(r.estimate); }},
    {"eta_neumann",
     [](const LevelRow& r) {
       return number(contribution<adaptivity::Source::Neumann>(r));
     }},
    {"eta_contact",
     [](const LevelRow& r) {
       return number(contribution<adaptivity::Source::Contact>(r));
     }},
    {"eta_density",
     [](const LevelRow& r) {
       return number(contribution<adaptivity::Source::Density>(r));
     }},
    {"eta_complementarity",
     [](const LevelRow& r) {
       return number(contribution<adaptivity::Source::Complementarity>(r));
     }},
    {"eta_penetration",
     [](const LevelRow& r) {
       return number(contribution<adaptivity::Source::Penetration>(r));
     }},
    {"eta_tension",
     [](const LevelRow& r) {
       return number(contribution<adaptivity::Source::Tension>(r));
     }},
    {"eta_bound",
     [](const LevelRow& r) {
       return number(contribution<adaptivity::Source::Bound>(r));
     }},
    {"eta_slip",
     [](const LevelRow& r) { return number(contribution<adaptivity::Source::Slip>(r)); }},
    {"energy_strain", [](const LevelRow& r) { return number(r.summary.energyStrain); }},
    {"energy_load", [](const LevelRow& r) { return number(r.summary.energyLoad); }},
    {"energy_friction",
     [](const LevelRow& r) { return number(r.summary.energyFriction); }},
    {"force_normal", [](const LevelRow& r) { return number(r.summary.forceNormal); }},
    {"force_tangential",
     [](const LevelRow& r) { return number(r.summary.forceTangential); }},
    {"reaction_x", [](const LevelRow& r) { return number(r.summary.reaction.x); }},
    {"reaction_y", [](const LevelRow& r) { return number(r.summary.reaction.y); }},
    {"reaction_moment",
     [](const LevelRow& r) { return number(r.summary.reaction.moment); }},
    {"contact_length", [](const LevelRow& r) { return number(r.summary.contactLength); }},
    {"slip_length", [](const LevelRow& r) { return number(r.summary.slipLength); }},
    {"newton_iterations",
     [](const LevelRow& r) { return number(r.report.newtonIterations); }},
    {"coulomb_iterations",
     [](const LevelRow& r) { return number(r.report.coulombIterations); }},
    {"status",
     [](const LevelRow& r) {
       return std::string(
           r.report.status == contact::Status::Converged ? "converged" : "not converged");
     }},
    {"seconds_assembly", [](const LevelRow& r) { return number(r.seconds.assembly); }},
    {"seconds_factorization",
     [](const LevelRow& r) { return number(r.seconds.factorization); }},
    {"seconds_stabilization",
     [](const LevelRow& r) { return number(r.seconds.stabilization); }},
    {"seconds_newton", [](const LevelRow& r) { return number(r.seconds.newton); }},
    {"seconds_estimate", [](const LevelRow& r) { return number(r.seconds.estimate); }},
    {"seconds_total", [](const LevelRow& r) { return number(r.secondsTotal); }},
    {"seconds_wall", [](const LevelRow& r) { return number(r.secondsWall); }},
    {"memory_mb", [](const LevelRow& r) { return number(r.memory); }},
    {"load_x", [](const LevelRow& r) { return number(r.summary.load.x); }},
    {"load_y", [](const LevelRow& r) { return number(r.summary.load.y); }},
    {"load_moment", [](const LevelRow& r) { return number(r.summary.load.moment); }},
    {"contact_x", [](const LevelRow& r) { return number(r.summary.contact.x); }},
    {"contact_y", [](const LevelRow& r) { return number(r.summary.contact.y); }},
    {"contact_moment",
     [](const LevelRow& r) { return number(r.summary.contact.moment); }},
    {"gamma0", [](const LevelRow& r) { return number(r.gamma0); }},
};

}  // namespace

std::vector<std::string> historyColumns() {
  std::vector<std::string> names;
  for (const Column& column : columns)
    names.emplace_back(column.name);
  return names;
}

std::vector<std::string> historyCells(const LevelRow& row) {
  std::vector<std::string> cells;
  for (const Column& column : columns)
    cells.push_back(column.cell(row));
  return cells;
}

std::string historyHead() { return csvLine(historyColumns()); }

std::string historyLine(const LevelRow& row) { return csvLine(historyCells(row)); }

std::vector<std::string> lastCells(const std::string& history) {
  const std::size_t begin = history.rfind('\n', history.size() - 2) + 1;
  std::istringstream line(history.substr(begin, history.size() - 1 - begin));
  std::vector<std::string> cells;
  for (std::string cell; std::getline(line, cell, ',');)
    cells.push_back(cell);
  return cells;
}

double energyOf(const std::vector<std::string>& cells) {
  const auto value = [&](const char* name) {
    const auto at = std::find_if(
        std::begin(columns), std::end(columns),
        [&](const Column& column) { return std::string(name) == column.name; });
    return std::stod(cells.at(static_cast<std::size_t>(at - std::begin(columns))));
  };
  return value("energy_strain") - value("energy_load") + value("energy_friction");
}

}  // namespace epafi::drivers
