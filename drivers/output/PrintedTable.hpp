#pragma once

#include "drivers/run/SolvedStep.hpp"

#include <string>

namespace epafi::drivers {

/// The table that a run prints: its head, and a line per level.
std::string tableHead();
std::string tableLine(const LevelRow& row);

/// One line per step of a path.
std::string tableLine(const StepRow& row);

/// Lines below that of a level, if there are any: a smaller γ₀ than `gamma0`, a fallback or a
/// cheaper choice of its operators, the step of a path that has the largest estimated error.
std::string notesOn(const LevelRow& row, double gamma0);

/// The largest contact pressure of a level, of all steps, for the end of a run; empty: none.
std::string pressureLine(const SolvedLevel& level);

/// CPU and elapsed time, time of each phase and peak memory, for the end of a run.
std::string timeSummary(const PhaseTimer& timer);

}  // namespace epafi::drivers
