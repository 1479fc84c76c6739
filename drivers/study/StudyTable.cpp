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

/// A row with the columns of history.csv.
CsvRow cells(const std::string& scene, const std::string& variant, const CsvRow& history,
             const StudiedLevel& studied) {
  const TrueError* error = studied.error ? &*studied.error : nullptr;
  const TrueError::Path* path = error != nullptr && error->path ? &*error->path : nullptr;
  const auto of = [](const auto* row, auto member) {
    return row == nullptr ? "" : number(row->*member);
  };
  CsvRow row = {{"scene", scene}, {"variant", variant}};
  append(row, history);
  append(row, {
                  {"error", of(error, &TrueError::relative)},
                  {"error_multiplier", of(error, &TrueError::multiplier)},
                  {"error_energy", of(error, &TrueError::energy)},
                  {"counted", error == nullptr ? "" : number(studied.counted)},
                  {"effectivity",
                   error == nullptr ? "" : number(studied.estimate / error->energyNorm)},
                  {"error_path", of(path, &TrueError::Path::relative)},
                  {"error_path_multiplier", of(path, &TrueError::Path::multiplier)},
                  {"error_path_friction", of(path, &TrueError::Path::friction)},
                  {"worst_step", of(path, &TrueError::Path::step)},
                  {"sweep_value", known(studied.sweepValue)},
                  {"smallest_eigenvalue", known(studied.smallestEigenvalue)},
                  {"reason", studied.reason},
                  {"folder", studied.folder},
              });
  return row;
}

}  // namespace

void StudyTable::level(const std::string& scene, const Variant& variant,
                       const LevelRow& row, const StudiedLevel& studied) {
  addRow(cells(scene, variant.name, cellsOf(row), studied), text_);
}

void StudyTable::failure(const std::string& scene, const Variant& variant, int level,
                         const StudiedLevel& studied) {
  CsvRow history = cellsOf(LevelRow());
  for (auto& [name, cell] : history)
    cell = name == "level" ? std::to_string(level) : name == "status" ? "failed" : "";
  addRow(cells(scene, variant.name, history, studied), text_);
}

void StudyTable::reference(const std::string& scene, const CsvRow& history) {
  addRow(cells(scene, "reference", history, {}), text_);
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
