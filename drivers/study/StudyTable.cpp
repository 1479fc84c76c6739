#include "drivers/study/StudyTable.hpp"

#include "drivers/output/Csv.hpp"
#include "drivers/output/PrintedTable.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace epafi::drivers {

namespace {

/// The number as a cell; empty for NaN.
std::string known(double value) { return std::isnan(value) ? "" : exactly(value); }

/// The columns behind those of history.csv.
struct Row {
  StudiedLevel studied;
  double estimate = 0;
  double sweepValue = std::numeric_limits<double>::quiet_NaN();
  std::string reason;
};

template <auto member>
std::string error(const Row& row) {
  return row.studied.error ? number((*row.studied.error).*member) : "";
}

template <auto member>
std::string path(const Row& row) {
  const auto& error = row.studied.error;
  return error && error->path ? number((*error->path).*member) : "";
}

constexpr Column<Row> columns[] = {
    {"error", error<&TrueError::relative>},
    {"error_multiplier", error<&TrueError::multiplier>},
    {"error_energy", error<&TrueError::energy>},
    {"counted",
     [](const Row& r) { return r.studied.error ? number(r.studied.counted) : ""; }},
    {"effectivity",
     [](const Row& r) {
       return r.studied.error ? number(r.estimate / r.studied.error->energyNorm) : "";
     }},
    {"error_path", path<&TrueError::Path::relative>},
    {"error_path_multiplier", path<&TrueError::Path::multiplier>},
    {"error_path_friction", path<&TrueError::Path::friction>},
    {"worst_step", path<&TrueError::Path::step>},
    {"sweep_value", [](const Row& r) { return known(r.sweepValue); }},
    {"smallest_eigenvalue",
     [](const Row& r) { return known(r.studied.smallestEigenvalue); }},
    {"reason", [](const Row& r) { return r.reason; }},
    {"folder", [](const Row& r) { return r.studied.folder; }},
};

std::string line(const std::string& scene, const std::string& variant,
                 std::vector<std::string> cells, const Row& row) {
  cells.insert(cells.begin(), {scene, variant});
  addCells(columns, row, cells);
  return csvLine(cells);
}

}  // namespace

StudyTable::StudyTable() {
  std::vector<std::string> names = historyColumns();
  names.insert(names.begin(), {"scene", "variant"});
  addNames(columns, "", names);
  text_ = csvLine(names);
}

void StudyTable::level(const std::string& scene, const Variant& variant,
                       const LevelRow& row, const StudiedLevel& studied) {
  text_ += line(scene, variant.name, historyCells(row),
                {studied, row.estimate, variant.sweepValue, row.reason});
}

void StudyTable::failure(const std::string& scene, const Variant& variant, int level,
                         const std::string& reason, double smallestEigenvalue) {
  std::vector<std::string> cells(historyColumns().size());
  cells[historyColumn("level")] = std::to_string(level);
  cells[historyColumn("status")] = "failed";
  Row row;
  row.studied.smallestEigenvalue = smallestEigenvalue;
  row.sweepValue = variant.sweepValue;
  row.reason = reason;
  text_ += line(scene, variant.name, cells, row);
}

void StudyTable::reference(const std::string& scene,
                           const std::vector<std::string>& cells) {
  text_ += line(scene, "reference", cells, Row());
}

/// The relative error; on a path the largest of all steps.
double largestOf(const TrueError& error) {
  return error.path ? error.path->relative : error.relative;
}

std::string studyHead() {
  return "  level    dof  density   estimate      error  effectivity  steps   CPU s\n";
}

std::string studyLine(const LevelRow& row, const StudiedLevel& studied) {
  std::ostringstream line;
  line << std::setw(7) << row.level << std::setw(7) << row.dof() << std::setw(9)
       << row.densities << std::setw(11) << significant(row.estimate, 4) << std::setw(11)
       << (studied.error ? significant(largestOf(*studied.error), 4) : "")
       << std::setw(13)
       << (studied.error ? significant(row.estimate / studied.error->energyNorm, 4) : "")
       << std::setw(7) << row.report.newtonIterations << std::setw(8)
       << std::setprecision(2) << std::fixed << row.secondsTotal
       << (studied.error && !studied.counted ? "  not counted" : "") << '\n';
  return line.str();
}

}  // namespace epafi::drivers
