#include "drivers/study/StudyTable.hpp"

#include "drivers/output/Csv.hpp"
#include "drivers/output/PrintedTable.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace epafi::drivers {

namespace {

std::string head() {
  std::vector<std::string> names = {"scene", "variant"};
  const std::vector<std::string> history = historyColumns();
  names.insert(names.end(), history.begin(), history.end());
  for (const char* name :
       {"error", "error_multiplier", "error_energy", "counted", "effectivity",
        "error_path", "error_path_multiplier", "error_path_friction", "worst_step",
        "sweep_value", "smallest_eigenvalue", "reason", "folder"})
    names.emplace_back(name);
  return csvLine(names);
}

/// Cells of errors, from "error" to "worst_step".
constexpr std::size_t errorCells = 9;

std::string known(double value) { return std::isnan(value) ? "" : exactly(value); }

}  // namespace

StudyTable::StudyTable() : text_(head()) {}

void StudyTable::row(const std::string& scene, const std::string& variant,
                     std::vector<std::string> cells,
                     const std::vector<std::string>& more) {
  cells.insert(cells.begin(), {scene, variant});
  cells.insert(cells.end(), more.begin(), more.end());
  text_ += csvLine(cells);
}

void StudyTable::level(const std::string& scene, const Variant& variant,
                       const LevelRow& levelRow, const StudiedLevel& studied) {
  std::vector<std::string> more;
  if (studied.error) {
    more = {exactly(studied.error->relative), exactly(studied.error->multiplier),
            exactly(studied.error->energy), studied.counted ? "1" : "0",
            exactly(levelRow.estimate / studied.error->energyNorm)};
    if (const auto& path = studied.error->path)
      for (const std::string& cell :
           {exactly(path->relative), exactly(path->multiplier), exactly(path->friction),
            std::to_string(path->step)})
        more.push_back(cell);
  }
  more.resize(errorCells);
  more.push_back(known(variant.sweepValue));
  more.push_back(known(studied.smallestEigenvalue));
  more.push_back(levelRow.reason);
  more.push_back(studied.folder);
  row(scene, variant.name, historyCells(levelRow), more);
}

void StudyTable::failure(const std::string& scene, const Variant& variant, int level,
                         const std::string& reason, double smallestEigenvalue) {
  std::vector<std::string> cells(historyColumns().size());
  cells[historyColumn("level")] = std::to_string(level);
  cells[historyColumn("status")] = "failed";
  std::vector<std::string> more(errorCells);
  more.push_back(known(variant.sweepValue));
  more.push_back(known(smallestEigenvalue));
  more.push_back(reason);
  more.emplace_back();
  row(scene, variant.name, std::move(cells), more);
}

void StudyTable::reference(const std::string& scene,
                           const std::vector<std::string>& cells) {
  row(scene, "reference", cells, std::vector<std::string>(errorCells + 4));
}

/// On a path of any step.
double largestOf(const TrueError& error) {
  return error.path ? error.path->relative : error.relative;
}

std::string studyHead() {
  return "  level    dof  density   estimate      error  effectivity  steps   CPU s\n";
}

std::string studyLine(const LevelRow& row, const StudiedLevel& studied) {
  std::ostringstream line;
  line << std::setw(7) << row.level << std::setw(7) << row.size.dof() << std::setw(9)
       << row.size.densities << std::setw(11) << significant(row.estimate, 4)
       << std::setw(11)
       << (studied.error ? significant(largestOf(*studied.error), 4) : "")
       << std::setw(13)
       << (studied.error ? significant(row.estimate / studied.error->energyNorm, 4) : "")
       << std::setw(7) << row.report.newtonIterations << std::setw(8)
       << std::setprecision(2) << std::fixed << row.secondsTotal
       << (studied.error && !studied.counted ? "  not counted" : "") << '\n';
  return line.str();
}

}  // namespace epafi::drivers
