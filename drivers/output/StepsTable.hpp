#pragma once

#include "drivers/run/Path.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// steps.csv: its head, with columns for each contact of the row and each body without
/// elasticity, and one line per level and step.
std::string stepsHead(const StepRow& row);
std::string stepsLine(const StepRow& row);

/// Friction's work up to each step of a level, as steps.csv has it; nothing of an empty text.
std::vector<double> dissipatedOf(const std::string& steps, int level);

}  // namespace epafi::drivers
