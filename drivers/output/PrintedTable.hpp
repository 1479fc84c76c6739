#pragma once

#include "drivers/process/PhaseTimer.hpp"
#include "drivers/run/Level.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// A number with `digits` significant digits.
std::string significant(double value, int digits);

/// The table that a run prints: its head, and a line per level.
std::string tableHead();
std::string tableLine(const LevelRow& row);

/// One line per step of a path.
std::string tableLine(const StepRow& row);

/// A note if the level uses a smaller γ₀ than `wanted`; else empty.
std::string gamma0Note(const LevelRow& row, double wanted);

/// The note on the operators of a level: a fallback or a cheaper choice; else empty.
std::string operatorsNote(const LevelRow& row);

/// A note with the step of a path that has the largest estimated error; else empty.
std::string worstStepNote(const LevelRow& row);

/// CPU and elapsed time, time of each phase and peak memory, for the end of a run.
std::string timeSummary(const PhaseTimer& timer);

}  // namespace epafi::drivers
