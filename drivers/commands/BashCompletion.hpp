#pragma once

#include "drivers/commands/Command.hpp"

#include <string>
#include <vector>

namespace epafi::drivers {

/// The commands as a completion for bash.
std::string bashCompletion(const std::vector<Command>& commands);

}  // namespace epafi::drivers
