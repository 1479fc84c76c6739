#pragma once

#include "drivers/process/PhaseTimer.hpp"
#include "drivers/run/Path.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// A number by so many digits.
std::string significant(double value, int digits);

/// The table that a run prints: its head, and one line per level.
std::string tableHead();
std::string tableLine(const LevelRow& row);

/// One line per step of a path.
std::string tableLine(const StepRow& row);

/// Says of a level that it has got less than the wanted γ₀; else empty.
std::string gamma0Note(const LevelRow& row, double wanted);

/// Says what became of a level's operators, or what would cost less; else empty.
std::string operatorsNote(const LevelRow& row);

/// Says of a level of a path which step has the largest estimated error; else empty.
std::string worstStepNote(const LevelRow& row);

/// Where the time went, for the end of a run.
std::string timeSummary(const PhaseTimer& timer);

}  // namespace epafi::drivers
