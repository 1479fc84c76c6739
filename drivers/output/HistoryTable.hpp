#pragma once

#include "drivers/run/Level.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// The columns of history.csv, and a row in their order.
std::vector<std::string> historyColumns();
std::vector<std::string> historyCells(const LevelRow& row);
/// Where one of them stands.  \pre there is one of this name
std::size_t historyColumn(const std::string& name);

/// history.csv: its head, and one line per level.
std::string historyHead();
std::string historyLine(const LevelRow& row);

/// The cells of the last line of a history.csv of this version.
std::vector<std::string> lastCells(const std::string& history);
/// Level::relativeEstimate as such cells have it.
double relativeEstimateOf(const std::vector<std::string>& cells);
/// strain and surface energy - fᵀ u + friction's work as such cells have it [stress length²].
double energyOf(const std::vector<std::string>& cells);

}  // namespace epafi::drivers
