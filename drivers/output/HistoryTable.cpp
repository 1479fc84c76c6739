#include "drivers/output/HistoryTable.hpp"

#include "drivers/output/Csv.hpp"
#include "drivers/scene/Text.hpp"

#include <cmath>
#include <limits>

namespace epafi::drivers {

namespace {

using adaptivity::Source;
using contact::Resultant;
using contact::Summary;

template <auto... members>
constexpr auto cell = cellOf<LevelRow, members...>;

template <auto member>
constexpr auto size = cell<&LevelRow::size, member>;

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

/// Order and names are a contract: add, never rename.
constexpr Column<LevelRow> columns[] = {
    {"level", cell<&LevelRow::level>},
    {"elements", size<&Size::elements>},
    {"dof_displacement", size<&Size::displacements>},
    {"dof_multiplier", size<&Size::multipliers>},
    {"dof", [](const LevelRow& r) { return number(r.size.dof()); }},
    {"dof_density", size<&Size::densities>},
    {"degree_min", size<&Size::degreeMin>},
    {"degree_max", size<&Size::degreeMax>},
    {"size_min", size<&Size::sizeMin>},
    {"size_max", size<&Size::sizeMax>},
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
    {"memory_forecast_mb", size<&Size::memory>},
    {"operators", [](const LevelRow& r) { return r.operators; }},
    {"worst_step", cell<&LevelRow::worstStep>},
    {"worst_step_estimate", cell<&LevelRow::worstEstimate>},
    {"estimate_relative", cell<&LevelRow::relativeEstimate>},
    {"energy_interface", cell<&LevelRow::energyInterface>},
};

}  // namespace

std::vector<std::string> historyColumns() {
  std::vector<std::string> names;
  addNames(columns, "", names);
  return names;
}

std::vector<std::string> historyCells(const LevelRow& row) {
  std::vector<std::string> cells;
  addCells(columns, row, cells);
  return cells;
}

std::size_t historyColumn(const std::string& name) {
  std::size_t at = 0;
  while (name != columns[at].name)
    ++at;
  return at;
}

std::string historyHead() { return csvLine(historyColumns()); }

std::string historyLine(const LevelRow& row) { return csvLine(historyCells(row)); }

std::vector<std::string> lastCells(const std::string& history) {
  const std::size_t begin = history.rfind('\n', history.size() - 2) + 1;
  return csvCells(history.substr(begin));
}

double relativeEstimateOf(const std::vector<std::string>& cells) {
  const std::string& cell = cells.at(historyColumn("estimate_relative"));
  return cell == "inf" ? std::numeric_limits<double>::infinity()
                       : numberIn<double>(cell).value();
}

double energyOf(const std::vector<std::string>& cells) {
  const auto value = [&](const char* name) {
    return numberIn<double>(cells.at(historyColumn(name))).value();
  };
  return value("energy_strain") - value("energy_load") + value("energy_friction") +
         value("energy_interface");
}

}  // namespace epafi::drivers
