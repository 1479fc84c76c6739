#pragma once

#include "drivers/run/Path.hpp"

#include <string>

namespace epafi::drivers {

/// steps.csv: its head, with columns for each contact of the row and each body without
/// elasticity, and one line per level and step.
std::string stepsHead(const StepRow& row);
std::string stepsLine(const StepRow& row);

}  // namespace epafi::drivers
