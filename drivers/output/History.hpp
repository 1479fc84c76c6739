#pragma once

#include "drivers/run/Level.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// The columns of history.csv, and a row in their order.
std::vector<std::string> historyColumns();
std::vector<std::string> historyCells(const LevelRow& row);

/// history.csv: its head, one line per level, or all of it.
std::string historyHead();
std::string historyLine(const LevelRow& row);
std::string historyCsv(const std::vector<LevelRow>& rows);

}  // namespace epafi::drivers
