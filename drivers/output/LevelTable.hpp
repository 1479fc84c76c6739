#pragma once

#include "drivers/output/History.hpp"
#include "drivers/process/PhaseTimer.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// The table that a run prints: its head, and one line per level.
std::string tableHead();
std::string tableLine(const LevelRow& row);

/// Where the time went, for the end of a run.
std::string timeSummary(const PhaseTimer& timer);

}  // namespace epafi::drivers
